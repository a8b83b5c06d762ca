#pragma once

#include "bench/plot/plot.h"
#include "bench/results/results.h"

namespace mapbed {

// A series over its iterations or time: for each variant and level the mean over all runs with its
// 95 % interval. Runs that go on for a shorter time than others count as far as they go.
Plot series_figure_of(const Results& results, const PlotSpec& spec);

}  // namespace mapbed
