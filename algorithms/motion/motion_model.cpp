#include "algorithms/motion/motion_model.h"

#include <cmath>

#include <Eigen/Dense>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// Of the errors of each part.
struct Sigmas {
  double first_rotation, translation, second_rotation;
};

Sigmas sigmas_of(const RotationTranslationRotation& motion, const MotionModelOptions& o) {
  const double d = std::abs(motion.translation);
  const auto rotation_sigma = [&](double turn) {
    return std::sqrt(o.rotation_per_rotation * o.rotation_per_rotation * std::abs(turn) +
                     o.rotation_per_meter * o.rotation_per_meter * d +
                     o.least_rotation_sigma * o.least_rotation_sigma);
  };
  return {rotation_sigma(motion.first_rotation),
          std::sqrt(o.translation_per_meter * o.translation_per_meter * d +
                    o.translation_per_rotation * o.translation_per_rotation *
                        (std::abs(motion.first_rotation) + std::abs(motion.second_rotation)) +
                    o.least_translation_sigma * o.least_translation_sigma),
          rotation_sigma(motion.second_rotation)};
}

RotationTranslationRotation corrected(RotationTranslationRotation motion,
                                      const MotionModelOptions& o) {
  motion.first_rotation -= o.rotation_bias * motion.first_rotation;
  motion.second_rotation -= o.rotation_bias * motion.second_rotation;
  motion.translation -= o.translation_bias * motion.translation;
  return motion;
}

}  // namespace

RotationTranslationRotation parts_of(const Pose2& motion) {
  constexpr double kLeastTranslation = 0.01;  // [m]
  return decomposed(motion, kLeastTranslation);
}

Pose2 sampled_motion(const Pose2& measured, const MotionModelOptions& options, Rng& rng) {
  const RotationTranslationRotation motion = corrected(parts_of(measured), options);
  const Sigmas sigma = sigmas_of(motion, options);
  const Pose2 result = composed({rng.normal(motion.first_rotation, sigma.first_rotation),
                                 rng.normal(motion.translation, sigma.translation),
                                 rng.normal(motion.second_rotation, sigma.second_rotation)});
  return result * Pose2{0.0, rng.normal(0.0, options.least_translation_sigma), 0.0};
}

PosePrior gaussian_after(const Pose2& start, const Pose2& measured,
                         const MotionModelOptions& options) {
  const RotationTranslationRotation motion = corrected(parts_of(measured), options);
  const Sigmas sigma = sigmas_of(motion, options);
  const Pose2 likeliest = composed(motion);
  // How the end moves with each part, in the frame of the end.
  Eigen::Matrix3d moves;
  const double sideways = motion.translation;  // by the first rotation, about the start
  const double c = std::cos(motion.second_rotation), s = std::sin(motion.second_rotation);
  moves << s * sideways, c, 0.0, c * sideways, -s, 0.0, 1.0, 0.0, 1.0;
  const Eigen::Vector3d variances(sigma.first_rotation * sigma.first_rotation,
                                  sigma.translation * sigma.translation,
                                  sigma.second_rotation * sigma.second_rotation);
  Eigen::Matrix3d covariance = moves * variances.asDiagonal() * moves.transpose();
  const double least = options.least_translation_sigma * options.least_translation_sigma;
  covariance.diagonal() += Eigen::Vector3d(least, least, 1e-8);
  return {.mean = start * likeliest, .information = covariance.inverse()};
}

}  // namespace mapbed
