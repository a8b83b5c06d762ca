#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/figures/people_moments.h"
#include "bench/results/result_file.h"
#include "bench/sources/run_input.h"
#include "core/config/settings.h"
#include "core/image/image.h"

namespace mapbed {

// A figure of chapter 3 about a moment of a drive. A new one is a file pair in this folder and a
// line in the table.
struct PeopleFigure {
  std::string name;
  std::string about;
  // The scans that it shows, by the time [s] since the log's start; without one it chooses.
  std::vector<std::size_t> (*scans)(const PeopleDrive& drive, std::optional<double> at);
  RgbImage (*draw)(const std::vector<PeopleMoment>& moments, int longest_side);
};

const std::vector<PeopleFigure>& people_figures();

// Throws InputError for an unknown name, with the nearest one.
const PeopleFigure& people_figure_by_name(const std::string& name);

// Throws InputError also where one is named twice.
void check_people_figures(const std::vector<std::string>& names);

// `settings` are of the people filter that follows them. Throws InputError for an option that it
// does not have, a time that is not in the log, and a log without scans.
RgbImage figure_of(const PeopleFigure& figure, const FigureLog& log, const Settings& settings,
                   std::optional<double> at, int longest_side);

// Those of a run, each at the moment that it chooses, by the filter's defaults.
std::vector<ResultFile> files_of_figures(const std::vector<std::string>& names,
                                         const RunInput& prepared);

}  // namespace mapbed
