#include "bench/figures/people_figures.h"

#include <algorithm>

#include <fmt/format.h>

#include "bench/figures/difference_figure.h"
#include "bench/figures/scan_figure.h"
#include "bench/figures/tracking_figure.h"
#include "bench/figures/weights_figure.h"
#include "core/config/option.h"
#include "core/config/suggestion.h"
#include "core/image/png.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kBetween = 0.6;  // [s] of the scans of a figure that shows several

std::vector<std::size_t> one_scan(const PeopleDrive& drive, std::optional<double> at) {
  return {at ? drive.scan_at(*at) : drive.busiest_scan()};
}

// Before, in the middle and at the end of an occlusion, and after it; or up to a time.
std::vector<std::size_t> several_scans(const PeopleDrive& drive, std::optional<double> at) {
  const auto occlusion = at ? std::nullopt : drive.longest_occlusion();
  if (occlusion) {
    return {drive.scan_at(std::max(0.0, drive.seconds_at(occlusion->first) - 0.5 * kBetween)),
            (occlusion->first + occlusion->last) / 2, occlusion->last,
            drive.scan_at(drive.seconds_at(occlusion->last) + kBetween)};
  }
  const double last = at.value_or(drive.seconds_at(drive.busiest_scan()));
  std::vector<std::size_t> scans;
  for (int before = 3; before >= 0; --before) {
    scans.push_back(drive.scan_at(std::max(0.0, last - before * kBetween)));
  }
  scans.erase(std::unique(scans.begin(), scans.end()), scans.end());
  return scans;
}

}  // namespace

const std::vector<PeopleFigure>& people_figures() {
  static const std::vector<PeopleFigure> table{
      {"scan", "what may be legs in a scan, and the occlusion grid, as Figure 3.1", one_scan,
       scan_figure},
      {"difference", "grids of two scans and which features moved by them, as Figure 3.2", one_scan,
       difference_figure},
      {"tracking", "samples of those who are followed, through an occlusion, as Figure 3.3",
       several_scans, tracking_figure},
      {"weights", "the weights of beams by who is followed, as Figures 3.4 and 3.5", one_scan,
       weights_figure},
  };
  return table;
}

const PeopleFigure& people_figure_by_name(const std::string& name) {
  std::vector<std::string> names;
  for (const PeopleFigure& figure : people_figures()) {
    if (figure.name == name) return figure;
    names.push_back(figure.name);
  }
  throw InputError({}, "unknown figure of people " + in_quotes(name), suggestion(name, names));
}

void check_people_figures(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    (void)people_figure_by_name(name);
    if (std::count(names.begin(), names.end(), name) > 1) {
      throw InputError({}, "the figure " + in_quotes(name) + " is named twice in people_figures");
    }
  }
}

RgbImage figure_of(const PeopleFigure& figure, const FigureLog& log, const Settings& settings,
                   std::optional<double> at, int longest_side) {
  PeopleFilter::Options options;
  apply(settings, options_of(options), "people");
  const PeopleDrive drive(log, options);
  const double length = drive.seconds_at(drive.scans() - 1);
  if (at && *at > length) {
    throw InputError(
        fmt::format("--at {:g} s is behind the last scan, which is at {:.1f} s", *at, length));
  }
  return figure.draw(drive.moments(figure.scans(drive, at)), longest_side);
}

std::vector<ResultFile> files_of_figures(const std::vector<std::string>& names,
                                         const RunInput& prepared) {
  if (names.empty()) return {};
  constexpr int kLongestSide = 1000;  // [pixels]
  const FigureLog log = figure_log_of(prepared);
  const PeopleDrive drive(log, {});
  std::vector<ResultFile> files;
  for (const std::string& name : names) {
    const PeopleFigure& figure = people_figure_by_name(name);
    const RgbImage image = figure.draw(drive.moments(figure.scans(drive, {})), kLongestSide);
    files.push_back({"maps/" + name + ".png", png_of(image), figure.about});
  }
  return files;
}

}  // namespace mapbed
