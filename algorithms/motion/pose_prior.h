#pragma once

#include <limits>

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace mapbed {

// A Gaussian belief about a pose. The error of a pose x is (x, y, theta) of inverse(mean) * x, that
// is, in the frame of the mean: forward, left, turn.
struct PosePrior {
  Pose2 mean;
  Eigen::Matrix3d information =
      Eigen::Matrix3d::Zero();  // [1/m^2, 1/(m rad), 1/rad^2]; zero: no belief
  // A second, wider Gaussian about the same mean, for what seldom happens; what it weighs beside
  // the first at the mean is below 1.
  Eigen::Matrix3d tail = Eigen::Matrix3d::Zero();
  double tail_log = -std::numeric_limits<double>::infinity();

  double log_at(const Pose2& x) const;  // up to a constant; 0 at the mean
  // Of the Gaussian that counts at x.
  const Eigen::Matrix3d& information_at(const Pose2& x) const;
};

// A prior whose forward, left and turn errors are independent. All sigmas > 0, [m], [m], [rad].
PosePrior independent_prior(const Pose2& mean, double sigma_forward, double sigma_left,
                            double sigma_turn);

// What two beliefs about one pose say together, to first order in their difference.
PosePrior fused(const PosePrior& a, const PosePrior& b);

}  // namespace mapbed
