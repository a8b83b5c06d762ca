#include "algorithms/motion/motion_model.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

TEST(MotionModel, WithoutErrorsGivesTheMeasuredMotion) {
  const MotionModelOptions exact{.rotation_per_rotation = 0,
                                 .rotation_per_meter = 0,
                                 .translation_per_meter = 0,
                                 .translation_per_rotation = 0,
                                 .least_rotation_sigma = 1e-12,
                                 .least_translation_sigma = 1e-12};
  Rng rng(1);
  for (const Pose2 motion : {Pose2{0.5, 0.1, 0.3}, Pose2{-0.5, 0.1, 0.3}, Pose2{0, 0, 1.0}}) {
    EXPECT_THAT(sampled_motion(motion, exact, rng), IsNear(motion, Tolerance{1e-9, 1e-9}));
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

}  // namespace
}  // namespace mapbed
