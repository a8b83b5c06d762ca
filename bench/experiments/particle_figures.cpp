#include "bench/experiments/particle_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "bench/plot/plot.h"

namespace mapbed {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr double kFinest = 1.0 / 1200.0;  // of the picture's larger side: half a pixel

// [cm], finer than any picture; full digits would make the files of many paths three times as long.
double rounded(double value) {
  return std::round(100.0 * value) / 100.0;
}

// [m] larger side of the box around all branches.
double extent_of(const std::vector<Trajectory>& branches) {
  Eigen::AlignedBox2d box;
  for (const Trajectory& branch : branches) {
    for (const Stamped<Pose2>& stamped : branch) box.extend(stamped.pose.position());
  }
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

double distance_to_line(const Pose2& pose, const Pose2& from, const Pose2& to) {
  const Eigen::Vector2d along = to.position() - from.position();
  const Eigen::Vector2d off = pose.position() - from.position();
  const double length = along.norm();
  if (length == 0.0) return off.norm();
  const double fraction = std::clamp(off.dot(along) / (length * length), 0.0, 1.0);
  return (off - fraction * along).norm();
}

// The poses of a path that a picture needs: all others lie within `tolerance` of the lines between
// them (Douglas and Peucker 1973). The paths of a thousand particles would fill megabytes.
Trajectory thinned(const Trajectory& path, double tolerance) {
  if (path.size() < 3) return path;
  std::vector<bool> kept(path.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> intervals{{0, path.size() - 1}};
  while (!intervals.empty()) {
    const auto [from, to] = intervals.back();
    intervals.pop_back();
    double farthest = tolerance;
    std::size_t worst = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = distance_to_line(path[i].pose, path[from].pose, path[to].pose);
      if (off <= farthest) continue;
      farthest = off;
      worst = i;
    }
    if (worst == from) continue;
    kept[worst] = true;
    intervals.emplace_back(from, worst);
    intervals.emplace_back(worst, to);
  }
  Trajectory result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (kept[i]) result.push_back(path[i]);
  }
  return result;
}

void append(const Trajectory& path, const Pose2& world_from_path, double tolerance,
            PlotSeries& series) {
  for (const Stamped<Pose2>& stamped : thinned(path, tolerance)) {
    const Pose2 pose = world_from_path * stamped.pose;
    series.x.push_back(rounded(pose.x));
    series.y.push_back(rounded(pose.y));
  }
  series.x.push_back(kGap);
  series.y.push_back(kGap);
}

// All of today's are their own ancestors.
int particles_of(const Hypotheses& hypotheses) {
  return hypotheses.diversity.empty() ? 1 : hypotheses.diversity.back().distinct_ancestors;
}

std::string labelled(const std::string& label, const std::string& text) {
  return label.empty() ? text : label + "; " + text;
}

std::vector<ResultFile> files_of(const std::string& name, const Plot& plot) {
  return {{"figures/" + name + ".svg", svg_of(plot)}, {"figures/" + name + ".csv", csv_of(plot)}};
}

}  // namespace

std::vector<ResultFile> path_figure(const Hypotheses& hypotheses, const Trajectory& truth,
                                    const Pose2& world_from_map, double seconds,
                                    const std::string& label) {
  if (hypotheses.branches.empty()) return {};
  const double tolerance = kFinest * extent_of(hypotheses.branches);
  PlotSeries particles{.name = "particles", .mark = Mark::path};
  for (const Trajectory& branch : hypotheses.branches) {
    append(branch, world_from_map, tolerance, particles);
  }
  const double now = hypotheses.branches.front().back().time;
  Trajectory so_far;
  // Where true poses are many, some of them show the path as well.
  const std::size_t every = 1 + truth.size() / 1000;
  for (std::size_t i = 0; i < truth.size() && truth[i].time <= now; i += every) {
    so_far.push_back(truth[i]);
  }
  PlotSeries true_path{.name = so_far.empty() ? "" : "true path", .mark = Mark::path};
  append(so_far, Pose2{}, tolerance, true_path);
  const std::string time = fmt::format("{:.0f}", seconds);
  const Plot plot{
      .title =
          fmt::format("What {} particles hold possible after {} s", particles_of(hypotheses), time),
      .subtitle =
          labelled(label, "the first seed, not aligned: all start at one pose; beside Figure 5.7"),
      .x = {"x", "m"},
      .y = {"y", "m"},
      .series = {particles, true_path},
      .equal_scales = true};
  return files_of("paths_after_" + time + "_s", plot);
}

}  // namespace mapbed
