#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/cli/command_line.h"
#include "core/config/settings.h"
#include "core/image/image.h"

namespace mapbed {

struct FigureArguments {
  std::string figure;  // empty: none is asked for
  std::string run;
  std::optional<int> number;          // of the run
  std::string at;                     // with its unit; empty: the figure chooses
  Settings settings;                  // of the people filter
  std::optional<int> longest_side;    // [pixels] of its panels
  std::vector<std::string> variants;  // of a scenario, whose maps are shown; empty: all
  std::optional<double> resolution;   // [m] of these maps
};

std::vector<CommandOption> figure_options(FigureArguments& arguments);  // that it has alone

// Throws InputError, and Interrupted.
RgbImage figure_of_run(const FigureArguments& arguments);

}  // namespace mapbed
