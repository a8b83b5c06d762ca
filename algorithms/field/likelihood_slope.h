#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "algorithms/field/likelihood_field.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// How ln p(z | x, m) of some points changes with small steps x, y, theta of the robot in its own
// frame.
struct LikelihoodSlope {
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  Eigen::Matrix3d curvature =
      Eigen::Matrix3d::Zero();  // of -ln p, positive semidefinite (Gauss-Newton)
};

// Of the points [begin, end), seen from a pose.
LikelihoodSlope likelihood_slope(const FieldPoints& points, std::size_t begin, std::size_t end,
                                 const LikelihoodField& map, const Pose2& map_from_robot);

}  // namespace mapbed
