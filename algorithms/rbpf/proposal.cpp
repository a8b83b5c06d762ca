#include "algorithms/rbpf/proposal.h"

#include <cmath>

#include <Eigen/Dense>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// A belief about the end of a step from a pose that is itself uncertain, with the mean of `step`.
PosePrior chained(const PosePrior& start, const PosePrior& step) {
  const Pose2 motion = motion_between(start.mean, step.mean);
  // How the end moves with the start, each in its own frame.
  const double c = std::cos(motion.theta), s = std::sin(motion.theta);
  Eigen::Matrix3d moves = Eigen::Matrix3d::Identity();
  moves.topLeftCorner<2, 2>() << c, s, -s, c;
  moves.topRightCorner<2, 1>() = moves.topLeftCorner<2, 2>() * Eigen::Vector2d(-motion.y, motion.x);
  const Eigen::Matrix3d covariance = moves * start.information.inverse() * moves.transpose() +
                                     Eigen::Matrix3d(step.information.inverse());
  return {.mean = step.mean, .information = covariance.inverse()};
}

// A belief about the end of the last step, after the condensed motion to `before`.
PosePrior prior_of_step(const Pose2& before, const UpdateMotion& motion,
                        const MotionErrors& errors) {
  if (motion.step_contradicted) {
    return independent_prior(before * motion.step.value_or(Pose2{}),
                             errors.contradicted_translation, errors.contradicted_translation,
                             errors.contradicted_rotation);
  }
  return motion.step ? gaussian_after(before, *motion.step, errors.odometry)
                     : predict_blindly(before, {}, motion.seconds, errors.blind);
}

}  // namespace

PosePrior prior_after(const Pose2& start, const UpdateMotion& motion, const MotionErrors& errors) {
  PosePrior condensed = gaussian_after(start, motion.condensed, errors.condensed);
  if (motion.condensed_doubt) {
    condensed.information = (condensed.information.inverse() + *motion.condensed_doubt).inverse();
  }
  return chained(condensed, prior_of_step(condensed.mean, motion, errors));
}

Pose2 drawn_from(const Pose2& mean, const Eigen::Matrix3d& covariance, Rng& rng) {
  const Eigen::Matrix3d root = covariance.llt().matrixL();
  const Eigen::Vector3d e = root * Eigen::Vector3d(rng.normal(), rng.normal(), rng.normal());
  return mean * Pose2{e.x(), e.y(), normalized_angle(e.z())};
}

}  // namespace mapbed
