#include "bench/experiments/rfid_reads/strength_figures.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "bench/plot/heat_map.h"
#include "bench/plot/plot.h"
#include "core/statistics/moments.h"

namespace mapbed {
namespace {

std::string antenna_name(int antenna) {
  return "antenna " + std::to_string(antenna + 1);
}

template <class Drawing>
void add(const Drawing& drawing, const std::string& name, const std::string& title,
         std::vector<ResultFile>& files) {
  files.push_back({"figures/" + name + ".svg", svg_of(drawing), title});
  files.push_back({"figures/" + name + ".csv", csv_of(drawing)});
}

Plot predicted_and_measured(const StrengthScore& score, int antennas) {
  Plot plot{.title = "RSSI at places held out",
            .subtitle = "a dot: mean of the reads of one tag at one place by one antenna",
            .x = {"predicted", "dBm"},
            .y = {"measured", "dBm"},
            .equal_scales = true};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  plot.series.resize(static_cast<std::size_t>(antennas));
  for (int i = 0; i < antennas; ++i) {
    plot.series[static_cast<std::size_t>(i)].name = antenna_name(i);
    plot.series[static_cast<std::size_t>(i)].mark = Mark::dots;
  }
  for (const StrengthScore::Prediction& prediction : score.predictions) {
    auto& series = plot.series[static_cast<std::size_t>(prediction.cell.reading.antenna)];
    series.x.push_back(prediction.strength);
    series.y.push_back(prediction.cell.reading.strength);
    low = std::min(low, prediction.strength);
    high = std::max(high, prediction.strength);
  }
  plot.series.push_back(
      {.name = "as predicted", .x = {low, high}, .y = {low, high}, .mark = Mark::path});
  return plot;
}

// With distance, tag and reflector taken off, the beam is left.
Plot over_the_angle(const StrengthModel& model, const std::vector<StrengthCell>& cells,
                    int antenna) {
  const SpatialAntenna& a = model.antennas[static_cast<std::size_t>(antenna)];
  PlotSeries measured{.name = "measured", .mark = Mark::dots};
  for (const StrengthCell& cell : cells) {
    if (cell.reading.antenna != antenna) continue;
    const double budget = link_budget(model, antenna, cell.reading.place);
    const double rest = budget + beam_loss(a, cell.reading.place) +
                        model.tags[static_cast<std::size_t>(cell.reading.tag)];
    measured.x.push_back(degrees(angle_off_boresight(a, cell.reading.place)));
    measured.y.push_back(cell.reading.strength - rest);
  }
  PlotSeries fitted{.name = "fitted", .mark = Mark::path};
  for (int angle = 0; angle <= 150; angle += 2) {
    const double turned = radians(angle) / a.beam_width;
    fitted.x.push_back(angle);
    fitted.y.push_back(-std::min(12.0 * turned * turned, a.back));
  }
  return {.title = "RSSI over the angle, " + antenna_name(antenna),
          .subtitle = "less level, distance and tag; boresight at azimuth " +
                      number_text(std::round(degrees(a.azimuth))) + " deg, elevation " +
                      number_text(std::round(degrees(a.elevation))) + " deg",
          .x = {"off the boresight", "deg"},
          .y = {"beam", "dB"},
          .series = {measured, fitted}};
}

// Of the plane at this height, in the mean of the tags, each less its own.
HeatMap map_of_plane(const StrengthModel& model, const std::vector<StrengthCell>& cells,
                     const PlacedReads& reads, int antenna, double height, bool measured) {
  std::set<double> xs, ys;
  for (const Eigen::Vector3d& place : reads.places) {
    xs.insert(place.x());
    ys.insert(place.y());
  }
  std::map<std::pair<double, double>, Moments> sums;
  for (const StrengthCell& cell : cells) {
    const Eigen::Vector3d& place = cell.reading.place;
    if (cell.reading.antenna != antenna || place.z() != height) continue;
    sums[{place.x(), place.y()}].add(cell.reading.strength -
                                     model.tags[static_cast<std::size_t>(cell.reading.tag)]);
  }
  const SpatialAntenna& a = model.antennas[static_cast<std::size_t>(antenna)];
  HeatMap map{
      .title = std::string(measured ? "Measured" : "Fitted") + " RSSI, " + antenna_name(antenna),
      .subtitle = "at z = " + number_text(height) + " m; boresight at azimuth " +
                  number_text(std::round(degrees(a.azimuth))) + " deg, elevation " +
                  number_text(std::round(degrees(a.elevation))) + " deg",
      .x = {"x", "m"},
      .y = {"y", "m"},
      .value = {.label = "RSSI", .unit = "dBm", .low = -85.0, .high = -60.0},
      .contours = !measured};
  if (measured) {
    map.xs.assign(xs.begin(), xs.end());
    map.ys.assign(ys.begin(), ys.end());
  } else {
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
      map.xs.push_back(*xs.begin() + (*xs.rbegin() - *xs.begin()) * i / kSteps);
      map.ys.push_back(*ys.begin() + (*ys.rbegin() - *ys.begin()) * i / kSteps);
    }
  }
  for (const double y : map.ys) {
    for (const double x : map.xs) {
      map.values.push_back(
          measured ? sums[{x, y}].mean()
                   : mean_of_read(model.threshold, link_budget(model, antenna, {x, y, height})));
    }
  }
  return map;
}

}  // namespace

std::vector<ResultFile> strength_figures(const StrengthScore& score, const StrengthModel& model,
                                         const std::vector<StrengthCell>& cells,
                                         const PlacedReads& reads) {
  std::vector<ResultFile> files;
  add(predicted_and_measured(score, reads.antennas), "predicted_measured",
      "predicted and measured RSSI of places held out", files);
  std::set<double> heights;
  for (const Eigen::Vector3d& place : reads.places) heights.insert(place.z());
  const double height = *std::next(heights.begin(), static_cast<long>(heights.size() / 2));
  for (int antenna = 0; antenna < reads.antennas; ++antenna) {
    const std::string number = std::to_string(antenna + 1);
    add(over_the_angle(model, cells, antenna), "beam_" + number,
        "RSSI over the angle off the boresight", files);
    if (reads.places.size() < 4) continue;
    add(map_of_plane(model, cells, reads, antenna, height, true), "measured_" + number,
        "RSSI as measured", files);
    add(map_of_plane(model, cells, reads, antenna, height, false), "fitted_" + number,
        "RSSI as fitted", files);
  }
  return files;
}

}  // namespace mapbed
