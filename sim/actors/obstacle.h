#pragma once

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace mapbed {

// Something solid that moves, seen from above, for who drives and walks: a disc (a body, a robot)
// or a flat leaf that begins at its frame's origin and lies along x.
struct Obstacle {
  Pose2 pose = {};                                     // world_from_obstacle
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // [m/s] in the world frame
  double radius = 0.0;                                 // [m] of a disc; 0: a leaf
  double length = 0.0;                                 // [m] of a leaf
  double thickness = 0.0;                              // [m] of a leaf

  bool is_disc() const { return radius > 0.0; }
};

}  // namespace mapbed
