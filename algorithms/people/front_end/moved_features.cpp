#include "algorithms/people/front_end/moved_features.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kThrough = 0.6;  // of the radius: a beam that passes nearer the axis would meet it
constexpr double kElsewhere = 0.3;     // [m] that something moved in the robot's frame, to tell
constexpr double kSameOnRobot = 0.08;  // [m] of the range to a part of the robot
constexpr int kLeastOnRobot = 3;       // scans that saw it there

}  // namespace

SeenBefore seen_at(const ScanView& view, const Eigen::Vector2d& point_in_robot, double radius,
                   double aside, double tolerance, const std::vector<bool>& on_people) {
  const LaserScan& scan = view.scan();
  bool is_free = false;
  for (const ScanView::Eye& eye : view.eyes()) {
    const double away = (point_in_robot - eye.origin).norm();
    if (away < 2.0 * tolerance) continue;
    const double bearing = eye.bearing_of(point_in_robot);
    const auto [first, last] = eye.within(bearing, (aside + radius) / away);
    bool passes = false;
    bool is_hidden = false;
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t beam = eye.beam(i);
      const double range = scan.ranges[beam];
      if (!(range > 0.0)) continue;
      if (!on_people.empty() && on_people[beam]) {
        is_hidden = is_hidden || range < away + tolerance;
      } else if (scan.is_hit(beam) && std::abs(range - away) <= tolerance) {
        return SeenBefore::same;
      } else if (range < away) {
        is_hidden = true;
      } else {
        const double off = std::abs(eye.bearings[i] - bearing) * away;
        passes = passes || off <= std::max(kThrough * radius, aside);
      }
    }
    is_free = is_free || (passes && !is_hidden);
  }
  return is_free ? SeenBefore::free : SeenBefore::nothing;
}

SeenBefore seen_again_at(const ScanView& view, const Eigen::Vector2d& point_in_robot) {
  constexpr double kRadius = 0.07;     // [m]
  constexpr double kAside = 0.05;      // [m]
  constexpr double kTolerance = 0.15;  // [m]
  return seen_at(view, point_in_robot, kRadius, kAside, kTolerance);
}

void RecentScans::add(ScanView view, const Pose2& local_from_robot, std::vector<bool> on_people) {
  CHECK(on_people.size() == view.scan().ranges.size());
  const bool is_soon = !scans_.empty() &&
                       view.scan().time - scans_.back().view.scan().time < options_.spacing - 1e-6;
  if (is_soon) return;
  scans_.push_back({std::move(view), inverse(local_from_robot), std::move(on_people)});
  if (scans_.size() > static_cast<std::size_t>(options_.scans)) scans_.pop_front();
}

PlaceBefore RecentScans::before(const LegFeature& feature, const Pose2& local_from_robot,
                                double radius) const {
  return before(feature.position, feature.spacing, local_from_robot, radius);
}

PlaceBefore RecentScans::before(const Eigen::Vector2d& point_in_robot, double spacing,
                                const Pose2& local_from_robot, double radius) const {
  const Eigen::Vector2d position = local_from_robot * point_in_robot;
  const double aside = 0.5 * spacing;
  PlaceBefore result;
  int telling = 0;  // scans in which the place was elsewhere in the robot's frame
  int on_robot = 0;
  ScanBits bit = 1;
  for (const Scan& scan : scans_) {
    const Eigen::Vector2d point = scan.robot_from_local * position;
    const SeenBefore seen =
        seen_at(scan.view, point, radius, aside, options_.tolerance, scan.on_people);
    if (seen == SeenBefore::free) result.free |= bit;
    if (seen == SeenBefore::same) result.same |= bit;
    bit <<= 1;
    if ((point - point_in_robot).norm() < kElsewhere) continue;
    ++telling;
    const SeenBefore there =
        seen_at(scan.view, point_in_robot, radius, aside, kSameOnRobot, scan.on_people);
    if (there == SeenBefore::same) ++on_robot;
  }
  result.rides_along = on_robot >= kLeastOnRobot && 2 * on_robot > telling;
  return result;
}

PastScans RecentScans::past(double now) const {
  PastScans past;
  past.least_free = options_.least_free;
  for (const Scan& scan : scans_) {
    if (now - scan.view.scan().time >= options_.lasting)
      past.old |= ScanBits{1} << past.times.size();
    past.times.push_back(scan.view.scan().time);
  }
  return past;
}

SeenBefore PastScans::verdict(const PlaceBefore& place, ScanBits without) const {
  if (place.rides_along) return SeenBefore::same;
  const int free_scans = std::popcount(place.free & ~without);
  const int same_scans = std::popcount(place.same & ~without);
  const bool stood = (place.same & ~without & old) != 0;
  const bool was_free = free_scans >= least_free;
  if (stood || (same_scans > 0 && same_scans >= free_scans)) {
    return was_free && 2 * free_scans >= same_scans ? SeenBefore::mixed : SeenBefore::same;
  }
  return was_free ? SeenBefore::free : SeenBefore::nothing;
}

}  // namespace mapbed
