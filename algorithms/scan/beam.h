#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "core/check.h"
#include "core/config/option.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// One beam of a scan as a straight line in the map.
struct Beam {
  Eigen::Vector2d start;  // [m] the laser, in the map frame
  Eigen::Vector2d end;    // [m] where the beam was reflected, or where it was followed to
  bool hit = true;        // false: it was not reflected up to `end` (zeta = 1 in (2.14))
};

// Which beams say something, and how far.
struct BeamLimits {
  double usable_range = 40.0;     // [m] beams are followed this far; what lies beyond is not used
  double no_return_range = 20.0;  // [m] a laser of longer maximum range that gets no return may
                                  // have met glass or something black as well as open space
};

template <class Visitor>
void visit_fields(BeamLimits& o, Visitor&& visit) {
  visit("usable_range", o.usable_range, Unit::meter, between(0.01, 1000.0),
        "beams are followed this far; what lies beyond is not used");
  visit("no_return_range", o.no_return_range, Unit::meter, kNotNegative,
        "a beam without return means free space where the laser's maximum range is at most this, "
        "and nothing where it is longer");
}

// visit(beam number, beam) for each beam of a scan that says something: not for failed ones (a
// range of 0 or less, or NaN) nor, with a laser of long range, for those without return. A beam
// that goes on after the usable range, like one of maximum range, clears its path and has no end.
template <class Visitor>
void for_each_beam(const LaserScan& scan, const Pose2& map_from_robot, const BeamLimits& limits,
                   Visitor&& visit) {
  CHECK(is_finite(map_from_robot));
  const Pose2 map_from_laser = map_from_robot * scan.robot_from_laser.planar;
  const bool is_of_one_place = scan.robot_from_beams.empty();
  for (std::size_t n = 0; n < scan.ranges.size(); ++n) {
    const double range = scan.ranges[n];
    if (!(range > 0.0)) continue;
    if (scan.is_max_range(n) && scan.max_range > limits.no_return_range) continue;
    const bool hit = scan.is_hit(n) && range <= limits.usable_range;
    const double length = std::min({range, scan.max_range, limits.usable_range});
    const Pose2 beam = is_of_one_place ? Pose2{map_from_laser.x, map_from_laser.y,
                                               map_from_laser.theta + scan.bearing(n)}
                                       : map_from_robot * scan.robot_from_beams[n];
    const Eigen::Vector2d start = beam.position();
    const Eigen::Vector2d end =
        start + length * Eigen::Vector2d(std::cos(beam.theta), std::sin(beam.theta));
    visit(n, Beam{start, end, hit});
  }
}

}  // namespace mapbed
