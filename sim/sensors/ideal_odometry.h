#pragma once

#include "core/geometry/pose2.h"

namespace mapbed {

// What odometry is made from.
struct IdealOdometry {
  double time = 0.0;              // [s]
  Pose2 truth;                    // world_from_robot
  Pose2 wheels;                   // by the wheels' turns alone, from the identity
  double forward_velocity = 0.0;  // [m/s] by the wheels
  double turn_velocity = 0.0;     // [rad/s] by the wheels
};

}  // namespace mapbed
