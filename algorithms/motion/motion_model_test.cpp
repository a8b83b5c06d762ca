#include "algorithms/motion/motion_model.h"

#include <cmath>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr MotionModelOptions kWithoutErrors{.rotation_per_rotation = 0,
                                            .rotation_per_meter = 0,
                                            .translation_per_meter = 0,
                                            .translation_per_rotation = 0,
                                            .least_rotation_sigma = 1e-12,
                                            .least_translation_sigma = 1e-12};

TEST(MotionModel, WithoutErrorsGivesTheMeasuredMotion) {
  Rng rng(1);
  for (const Pose2 motion : {Pose2{0.5, 0.1, 0.3}, Pose2{-0.5, 0.1, 0.3}, Pose2{0, 0, 1.0}}) {
    EXPECT_THAT(sampled_motion(motion, kWithoutErrors, rng), IsNear(motion, Tolerance{1e-9, 1e-9}));
  }
}

// The Gaussian used by searches has the moments of the samples, to first order in the errors.
TEST(MotionModel, TheGaussianHasTheCovarianceOfTheSamples) {
  const MotionModelOptions options{
      .rotation_per_rotation = 0.05, .rotation_per_meter = 0.03, .translation_per_meter = 0.05};
  const Pose2 motion{1.0, 0.2, 0.4};
  const PosePrior gaussian = gaussian_after({}, motion, options);
  constexpr int n = 20'000;
  Rng rng(3);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (int i = 0; i < n; ++i) {
    const Pose2 error = motion_between(gaussian.mean, sampled_motion(motion, options, rng));
    const Eigen::Vector3d e(error.x, error.y, error.theta);
    scatter += e * e.transpose() / n;
  }
  const Eigen::Matrix3d expected = gaussian.information.inverse();
  for (int i = 0; i < 3; ++i) {
    // A variance of n samples has the relative standard error sqrt(2 / n) = 1 %; 5 of them, and the
    // second order of the errors.
    EXPECT_NEAR(scatter(i, i) / expected(i, i), 1.0, 0.08);
  }
}

// Straight on for 2 m, and then a turn: a tenth of both rotations is not there.
TEST(MotionModel, TakesTheBiasOffBothRotations) {
  MotionModelOptions options = kWithoutErrors;
  options.rotation_bias = 0.1;
  Rng rng(1);
  const Pose2 first = composed({0.5, 2.0, 0.0}), second = composed({0.0, 2.0, 0.8});
  EXPECT_THAT(sampled_motion(first, options, rng),
              IsNear(composed({0.45, 2.0, 0.0}), Tolerance{1e-9, 1e-9}));
  EXPECT_THAT(sampled_motion(second, options, rng),
              IsNear(composed({0.0, 2.0, 0.72}), Tolerance{1e-9, 1e-9}));
}

// By 5 cm after 1 rad, however the turns lie: the root of 0.3 rad and 0.5 rad together.
TEST(MotionModel, BothRotationsMakeTheTranslationUnsure) {
  MotionModelOptions options = kWithoutErrors;
  options.translation_per_rotation = 0.05;
  const Pose2 motion = composed({0.3, 1.0, 0.5});
  constexpr int n = 10'000;
  Rng rng(2);
  double squares = 0.0;
  for (int i = 0; i < n; ++i) {
    const Pose2 sample = sampled_motion(motion, options, rng);
    const double error = std::hypot(sample.x, sample.y) - 1.0;
    squares += error * error / n;
  }
  const double sigma = 0.05 * std::sqrt(0.8);
  EXPECT_NEAR(std::sqrt(squares), sigma, 5 * sigma / std::sqrt(2.0 * n));
}

// An error of 10 cm along the way, seen from an end that is turned by 45 degrees to the left.
TEST(MotionModel, TheGaussianIsInTheFrameOfTheEnd) {
  MotionModelOptions options = kWithoutErrors;
  options.translation_per_meter = 0.1;
  options.least_rotation_sigma = options.least_translation_sigma = 1e-3;  // 1e-6 in variances
  const PosePrior along = gaussian_after({}, composed({0.0, 1.0, kPi / 4}), options);
  const Eigen::Matrix3d covariance = along.information.inverse();
  EXPECT_NEAR(covariance(0, 0), 0.005, 1e-5);
  EXPECT_NEAR(covariance(1, 1), 0.005, 1e-5);
  // Along the way is (1, -1) / sqrt(2) there.
  EXPECT_NEAR(covariance(0, 1), -0.005, 1e-5);
}

// An error of 0.1 rad of the first rotation alone carries the end of 1 m aside and turns it. Seen
// from an end that is turned by 45 degrees to the left, aside is (1, 1) / sqrt(2).
TEST(MotionModel, AnErrorOfTheFirstRotationCarriesTheEndAside) {
  MotionModelOptions options = kWithoutErrors;
  options.rotation_per_meter = 0.1;        // of the second rotation too, which turns the end alone
  options.least_translation_sigma = 1e-3;  // 1e-6 in variances
  const Eigen::Matrix3d covariance =
      gaussian_after({}, composed({0.0, 1.0, kPi / 4}), options).information.inverse();
  const double variance = 0.01;
  EXPECT_NEAR(covariance(0, 0), 0.5 * variance, 1e-5);
  EXPECT_NEAR(covariance(0, 1), 0.5 * variance, 1e-5);
  EXPECT_NEAR(covariance(0, 2), std::sqrt(0.5) * variance, 1e-5);
  EXPECT_NEAR(covariance(1, 2), std::sqrt(0.5) * variance, 1e-5);
  EXPECT_NEAR(covariance(2, 2), 2.0 * variance, 1e-5);
}

}  // namespace
}  // namespace mapbed
