#pragma once

#include "core/geometry/pose2.h"

namespace mapbed {

// The robot's pose by its own dead reckoning, in a frame that is fixed but means nothing.
struct Odometry {
  double time = 0.0;  // [s] the log's own absolute stamp
  Pose2 odometry_from_robot;
  double forward_velocity = 0.0;  // [m/s] 0 where the log has none
  double turn_velocity = 0.0;     // [rad/s] 0 where the log has none
  // The pose goes on from the reading before by guess: nobody knows how the robot moved between.
  bool motion_unknown = false;
};

}  // namespace mapbed
