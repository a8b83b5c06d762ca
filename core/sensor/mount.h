#pragma once

#include "core/geometry/pose2.h"

namespace mapbed {

struct Pose3;

// Where a sensor sits on its robot. Kept as a place in the plan and what lifts and tilts it out of
// it, so that methods in the plane use `planar` as it stands.
struct Mount {
  Pose2 planar;        // robot_from_sensor, seen from above
  double z = 0.0;      // [m] above the floor
  double pitch = 0.0;  // [rad] positive: looks down
  double roll = 0.0;   // [rad]

  Pose3 pose() const;     // robot_from_sensor
  bool is_level() const;  // its plane of measurement is the robot's, to within 0.1 degrees
  friend bool operator==(const Mount&, const Mount&) = default;
};

}  // namespace mapbed
