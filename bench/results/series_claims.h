#pragma once

#include "bench/results/claim.h"
#include "bench/results/results.h"

namespace mapbed {

// A claim about a series is one about a single value of it: the first, the last or that at some x,
// which 'at' names beside the axes.

// Throws InputError where a claim about a series of the plan does not say which value it takes.
void check_taken_value(const Claim& claim, const Results& plan);

// The claim with that value as its metric: without the place in the series.
Claim as_metric_claim(Claim claim, const Results& plan);

// The results as if what the claim takes of each series had been measured: its metrics, runs and
// summary. A run has no value where its series is missing, or ends before x and does
// not stay there.
Results with_series_as_metrics(const Results& results, const Claim& claim);

// On the straight line between the neighbours of x; NaN beyond the ends, but where the metric stays
// where it ends.
double value_at(const Series& series, const SeriesMetric& metric, double x);

}  // namespace mapbed
