#include "bench/cli/render/render_figure.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "bench/cli/interrupt.h"
#include "bench/cli/progress.h"
#include "bench/cli/render/run_to_film.h"
#include "bench/figures/map_taker.h"
#include "bench/figures/people_figures.h"
#include "bench/plot/map_figure.h"
#include "core/config/quantity.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr int kLongestSide = 1100;         // [pixels]
constexpr const char* kMaps = "maps";      // of a scenario's variants
constexpr const char* kLabels = "labels";  // the same, and what they leave out

// The run as far as the viewer wants to see it.
void watch(const RunToFilm& run, RunViewer& viewer, const InterruptGuard& interrupt) {
  try {
    run.record(viewer, [&] { return !interrupt.was_interrupted(); });
  } catch (const Interrupted&) {
    if (!viewer.is_complete()) throw;
  }
}

RgbImage figure_of_people(const PeopleFigure& figure, const FigureArguments& a) {
  std::optional<double> at;
  if (!a.at.empty()) at = parse_quantity(a.at, Unit::second, {"--at", 0});
  if (at && *at < 0.0) throw InputError({"--at"}, "must not be negative");
  if (!a.variants.empty() || a.resolution) {
    throw InputError("--variant and --resolution are of the figures maps and labels");
  }
  const std::unique_ptr<RunToFilm> run = run_to_film(a.run, a.number);
  const InterruptGuard interrupt;
  LogTaker taker;
  while_told("repeating " + run->words(), [&] { watch(*run, taker, interrupt); });
  return while_told("following people", [&] {
    return figure_of(figure, taker.taken(), a.settings, at, a.longest_side.value_or(kLongestSide));
  });
}

RgbImage figure_of_maps(const FigureArguments& a) {
  if (!a.at.empty() || !a.settings.empty()) {
    throw InputError("--at and --set say nothing of the figure " + a.figure);
  }
  MapOptions options;
  options.resolution = a.resolution.value_or(options.resolution);
  const InterruptGuard interrupt;
  std::vector<NamedMap> maps;
  for (const VariantRun& variant : runs_of_variants(a.run, a.number, a.variants)) {
    MapTaker taker(options);
    while_told("repeating " + variant.run->words(), [&] { watch(*variant.run, taker, interrupt); });
    maps.push_back(taker.taken());
    maps.back().name = variant.variant;
    if (a.figure == kMaps) maps.back().dynamic = {};
  }
  return figure_of(maps, a.longest_side.value_or(kLongestSide));
}

}  // namespace

std::vector<CommandOption> figure_options(FigureArguments& arguments) {
  const std::string of_figure = "Of a figure of a run";
  std::string figures;
  for (const PeopleFigure& figure : people_figures()) {
    figures += figure.name + ": " + figure.about + "; ";
  }
  return {{.name = "--figure",
           .target = &arguments.figure,
           .help = figures + kMaps +
                   ": of a scenario's variants beside each other, as Figures 3.7, 3.9, 4.5, 4.7; " +
                   kLabels + ": the same with what they leave out, as Figures 4.3 and 4.6",
           .group = of_figure},
          {.name = "--at",
           .target = &arguments.at,
           .help = "since the log's start, as in '12.5 s'; where left out, the moment with the "
                   "most people, or the longest occlusion",
           .group = of_figure},
          {.name = "--variant",
           .target = &arguments.variants,
           .help = "whose maps are shown, all of the scenario's where left out; may come again",
           .group = of_figure}};
}

RgbImage figure_of_run(const FigureArguments& arguments) {
  if (arguments.figure == kMaps || arguments.figure == kLabels) return figure_of_maps(arguments);
  std::vector<std::string> names{kMaps, kLabels};
  for (const PeopleFigure& figure : people_figures()) {
    if (figure.name == arguments.figure) return figure_of_people(figure, arguments);
    names.push_back(figure.name);
  }
  throw InputError({"--figure"}, "unknown figure " + in_quotes(arguments.figure),
                   suggestion(arguments.figure, names));
}

}  // namespace mapbed
