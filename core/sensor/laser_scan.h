#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/sensor/mount.h"

namespace mapbed {

// The scan of one laser, as it was recorded, within one that is fused of several.
struct ScanPart {
  double time = 0.0;  // [s] its own stamp
  int laser = 0;
  std::size_t beams = 0;  // that it has in the fused one, in its own order
};

// One sweep of a laser range finder whose beams lie in one plane.
struct LaserScan {
  double time = 0.0;  // [s] the log's own stamp; of the first beam where they have a period
  int laser = 0;      // of the robot's lasers: 0 front, 1 rear, further ones as the log counts them
  Mount robot_from_laser;
  double first_bearing = 0.0;  // [rad] of ranges[0], in the laser frame
  double bearing_step = 0.0;   // [rad] from one beam to the next; positive: counter-clockwise
  double beam_period = 0.0;    // [s] from one beam to the next, negative where the last comes
                               // first; 0: all at once, or nobody knows
  double max_range = 0.0;      // [m] a range of max_range or more means: nothing was hit
  std::vector<double> ranges;  // [m] 0 or less: the beam failed and says nothing at all; none
                               // where the laser told nothing new, but was there
  // Where each beam starts and looks, in the robot's frame at the stamp: of beams that were taken
  // one after the other, or by several lasers. Empty: all start at the mount, by their bearings.
  std::vector<Pose2> robot_from_beams;
  std::vector<ScanPart> parts;     // of one that is fused, in order; empty: it is a laser's own
  std::vector<double> remissions;  // reflected intensity as the log has it; empty where it has none

  double bearing(std::size_t beam) const {
    return first_bearing + static_cast<double>(beam) * bearing_step;
  }
  // Where a beam is after `range` [m], in the robot frame.
  Eigen::Vector2d point_on(std::size_t beam, double range) const {
    if (!robot_from_beams.empty()) return robot_from_beams[beam] * Eigen::Vector2d(range, 0.0);
    const double angle = bearing(beam);
    return robot_from_laser.planar *
           Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle));
  }
  bool is_hit(std::size_t beam) const { return ranges[beam] > 0.0 && ranges[beam] < max_range; }
  bool is_max_range(std::size_t beam) const { return ranges[beam] >= max_range; }
};

}  // namespace mapbed
