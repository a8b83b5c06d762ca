#pragma once

#include <string>

#include "bench/results/result_folder.h"

namespace mapbed {

// The page of one scenario: the question, the claims with the thesis beside them, figures, maps,
// replays, all numbers, and what they were made with. One file that needs no network.
std::string scenario_page(const ResultFolder& result);

// Parts that the overview shows too.
std::string claims_html(const ResultFolder& result);
std::string badges_html(const ResultFolder& result);

}  // namespace mapbed
