#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "core/check.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// One beam of a scan as a straight line in the map.
struct Beam {
  Eigen::Vector2d start;  // [m] the laser, in the map frame
  Eigen::Vector2d end;    // [m] where the beam was reflected, or where it was followed to
  bool hit = true;        // false: it was not reflected up to `end` (zeta = 1 in (2.14))
};

// visit(beam number, beam) for each beam of a scan that says something: not for failed ones (a
// range of 0 or less, or NaN). A beam is followed for `usable_range` [m] at most; one that goes on,
// like one of maximum range, clears its path and has no end.
template <class Visitor>
void for_each_beam(const LaserScan& scan, const Pose2& map_from_robot, double usable_range,
                   Visitor&& visit) {
  CHECK(is_finite(map_from_robot));
  const Pose2 map_from_laser = map_from_robot * scan.robot_from_laser;
  const Eigen::Vector2d start(map_from_laser.x, map_from_laser.y);
  for (std::size_t n = 0; n < scan.ranges.size(); ++n) {
    const double range = scan.ranges[n];
    if (!(range > 0.0)) continue;
    const bool hit = scan.is_hit(n) && range <= usable_range;
    const double length = std::min({range, scan.max_range, usable_range});
    const double angle = map_from_laser.theta + scan.bearing(n);
    const Eigen::Vector2d end = start + length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    visit(n, Beam{start, end, hit});
  }
}

}  // namespace mapbed
