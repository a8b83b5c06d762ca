#pragma once

#include <string>

#include "bench/pages/reported_results.h"

namespace mapbed {

// The page of one scenario: the question, the claims with the thesis beside them, figures, maps,
// replays, all numbers, and what they were made with. One file that needs no network.
std::string scenario_page(const ReportedResults& reported);

// How the claims stand; a quick run judges none.
struct ClaimCount {
  int held = 0;
  int not_held = 0;
  int not_judged = 0;
};
ClaimCount claims_of(const Results& results);
int failed_runs(const Results& results);
bool stands_beside_thesis(const Results& results);  // at least one of the claims

// Parts that the overview shows too.
std::string claims_html(const Results& results);
std::string badges_html(const Results& results);

}  // namespace mapbed
