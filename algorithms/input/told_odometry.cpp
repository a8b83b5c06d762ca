#include "algorithms/input/told_odometry.h"

#include <algorithm>

namespace mapbed {

ToldOdometry::ToldOdometry(const SensorLog& log) {
  for (const Measurement& measurement : log) {
    const auto* reading = std::get_if<Odometry>(&measurement);
    if (reading == nullptr) continue;
    if (!readings_.empty() && reading->time <= readings_.back().time) continue;
    readings_.push_back(*reading);
  }
}

std::optional<Pose2> ToldOdometry::at(double time) const {
  const auto after =
      std::lower_bound(readings_.begin(), readings_.end(), time,
                       [](const Odometry& reading, double stamp) { return reading.time < stamp; });
  if (after == readings_.end()) return {};
  if (after->time == time) return after->odometry_from_robot;
  if (after == readings_.begin()) return {};
  const Odometry& before = *(after - 1);
  const double gap = after->time - before.time;
  if (gap > kLongestGap) return {};
  return interpolate(before.odometry_from_robot, after->odometry_from_robot,
                     (time - before.time) / gap);
}

std::optional<Pose2> ToldOdometry::motion(double from, double to) const {
  const std::optional<Pose2> a = at(from), b = at(to);
  return a && b ? std::optional<Pose2>(motion_between(*a, *b)) : std::optional<Pose2>{};
}

std::vector<double> ToldOdometry::unknown() const {
  std::vector<double> result;
  for (const Odometry& reading : readings_) {
    if (reading.motion_unknown) result.push_back(reading.time);
  }
  return result;
}

}  // namespace mapbed
