#include "bench/experiments/particle_figures.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "bench/report/plot.h"

namespace mapbed {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

// Finer than any picture; full digits would make the files of many paths three times as long.
double rounded(double value) {
  return std::round(1000.0 * value) / 1000.0;
}

void append(const Trajectory& path, const Pose2& world_from_path, Series& series) {
  for (const StampedPose& stamped : path) {
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

std::vector<ResultFile> files_of(const std::string& name, const Plot& plot) {
  return {{"figures/" + name + ".svg", svg_of(plot)}, {"figures/" + name + ".csv", csv_of(plot)}};
}

}  // namespace

std::vector<ResultFile> path_figure(const Hypotheses& hypotheses, const Trajectory& truth,
                                    const Pose2& world_from_map, double seconds) {
  if (hypotheses.branches.empty()) return {};
  Series particles{.name = "paths of all particles", .mark = Mark::path};
  for (const Trajectory& branch : hypotheses.branches) append(branch, world_from_map, particles);
  const double now = hypotheses.branches.front().back().time;
  Trajectory so_far;
  // Where true poses are many, some of them show the path as well.
  const std::size_t every = 1 + truth.size() / 1000;
  for (std::size_t i = 0; i < truth.size() && truth[i].time <= now; i += every) {
    so_far.push_back(truth[i]);
  }
  Series true_path{.name = so_far.empty() ? "" : "true path", .mark = Mark::path};
  append(so_far, Pose2{}, true_path);
  const std::string time = fmt::format("{:.0f}", seconds);
  const Plot plot{
      .title =
          fmt::format("What {} particles hold possible after {} s", particles_of(hypotheses), time),
      .subtitle = "the first seed, not aligned: all start at one pose; beside Figure 5.7",
      .x = {"x", "m"},
      .y = {"y", "m"},
      .series = {particles, true_path},
      .equal_scales = true};
  return files_of("paths_after_" + time + "_s", plot);
}

std::vector<ResultFile> diversity_figure(const Hypotheses& hypotheses) {
  if (hypotheses.diversity.empty()) return {};
  Series ancestors{.name = "ancestors of the particles at the end", .mark = Mark::path};
  Series effective{.name = "effective number of particles", .mark = Mark::path};
  const double start = hypotheses.diversity.front().time;
  for (const Diversity& update : hypotheses.diversity) {
    const double time = rounded(update.time - start);
    ancestors.x.push_back(time);
    ancestors.y.push_back(update.distinct_ancestors);
    effective.x.push_back(time);
    effective.y.push_back(rounded(update.effective_number));
  }
  const Plot plot{
      .title = fmt::format("How many possibilities {} particles hold", particles_of(hypotheses)),
      .subtitle = "the first seed; before resampling at each update",
      .x = {"time since the start", "s"},
      .y = {.label = "particles", .logarithmic = true},
      .series = {effective, ancestors}};
  return files_of("diversity", plot);
}

}  // namespace mapbed
