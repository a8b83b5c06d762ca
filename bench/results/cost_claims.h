#pragma once

#include "bench/results/claim.h"
#include "bench/results/results.h"

namespace mapbed {

// Claims may be about time as well, by the names of the table below. As that differs from run to
// run of the same program, their verdicts stand apart, in cost_claims.csv.

// Name, unit and meaning.
const std::vector<Metric>& cost_metrics();

bool is_about_cost(const Claim& claim);

// The results as if the cost were what had been measured: its metrics, runs and summary.
Results with_costs_as_metrics(const Results& results);

}  // namespace mapbed
