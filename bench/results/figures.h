#pragma once

#include <string>
#include <vector>

#include "bench/plot/heat_map.h"
#include "bench/plot/matrix.h"
#include "bench/plot/plot.h"
#include "bench/results/result_file.h"
#include "bench/results/results.h"

namespace mapbed {

// One of a scenario's plots, from its summary (lines, bars), its runs (points) or their series.
// Lines and bars show means with their 95 % intervals; failed runs are counted in the subtitle.
// Angles are shown in degrees.
Plot figure_of(const Results& results, const PlotSpec& spec);

// The same of a plot of that kind: means as colours.
HeatMap heat_map_of(const Results& results, const PlotSpec& spec);
Matrix matrix_of(const Results& results, const PlotSpec& spec);

// Each of Results::plots as figures/<file>.svg with its numbers as <file>.csv; no heat map of a
// reduced run that has fewer than two levels along one side.
std::vector<ResultFile> figure_files(const Results& results);

// Writes them below the folder of a result.
void write_figures(const std::string& folder, const Results& results);

}  // namespace mapbed
