#pragma once

#include <vector>

#include "bench/results/results.h"

namespace mapbed {

// Of all runs: a row for each level, variant and metric, the last one fastest.
std::vector<SummaryRow> summary_of(const Results& results);

}  // namespace mapbed
