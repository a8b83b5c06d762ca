#pragma once

#include <span>

#include <Eigen/Core>

#include "algorithms/localization/pose_bins.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// What weighted particles say in one pose: the mean of those about the place that most of the
// belief is about.
struct PoseAnswer {
  Pose2 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of x, y [m] and theta [rad] in the map
  double weight = 0.0;  // of those particles; what is missing to 1 is elsewhere

  double largest_sigma() const;  // [m] of the position, in the worst direction
};

// Weights are normalised. Not for an empty list.
PoseAnswer answer_of(std::span<const Pose2> poses, std::span<const double> weights,
                     const PoseBinOptions& options);

}  // namespace mapbed
