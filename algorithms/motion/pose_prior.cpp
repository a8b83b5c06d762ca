#include "algorithms/motion/pose_prior.h"

#include <Eigen/Dense>

#include "core/check.h"

namespace mapbed {

double PosePrior::log_at(const Pose2& x) const {
  const Pose2 error = motion_between(mean, x);
  const Eigen::Vector3d e(error.x, error.y, error.theta);
  return std::max(-0.5 * e.dot(information * e), tail_log - 0.5 * e.dot(tail * e));
}

const Eigen::Matrix3d& PosePrior::information_at(const Pose2& x) const {
  const Pose2 error = motion_between(mean, x);
  const Eigen::Vector3d e(error.x, error.y, error.theta);
  return -0.5 * e.dot(information * e) >= tail_log - 0.5 * e.dot(tail * e) ? information : tail;
}

PosePrior independent_prior(const Pose2& mean, double sigma_forward, double sigma_left,
                            double sigma_turn) {
  CHECK(sigma_forward > 0.0 && sigma_left > 0.0 && sigma_turn > 0.0);
  PosePrior prior{.mean = mean};
  prior.information.diagonal() << 1.0 / (sigma_forward * sigma_forward),
      1.0 / (sigma_left * sigma_left), 1.0 / (sigma_turn * sigma_turn);
  return prior;
}

PosePrior fused(const PosePrior& a, const PosePrior& b) {
  const Eigen::Matrix3d information = a.information + b.information;
  const Pose2 off = motion_between(a.mean, b.mean);
  const Eigen::Vector3d step =
      information.ldlt().solve(b.information * Eigen::Vector3d(off.x, off.y, off.theta));
  return {.mean = a.mean * Pose2{step.x(), step.y(), step.z()}, .information = information};
}

}  // namespace mapbed
