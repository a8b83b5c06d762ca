#include "algorithms/rbpf/proposal.h"

#include <cmath>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

const Tolerance kExact{1e-9, 1e-9};
const Pose2 kStart{2.0, -1.0, 0.7};
const MotionErrors kErrors{.condensed = {.rotation_per_rotation = 0.02,
                                         .rotation_per_meter = 0.02,
                                         .translation_per_meter = 0.02},
                           .odometry = {.rotation_per_rotation = 0.03,
                                        .rotation_per_meter = 0.01,
                                        .translation_per_meter = 0.04},
                           .blind = {},
                           .contradicted_translation = 1.0,
                           .contradicted_rotation = 3.15};
const UpdateMotion kMotion{.condensed = {0.5, 0.1, 0.6}, .step = Pose2{0.8, -0.2, -0.4}};

// Of the errors about the mean, in its frame.
Eigen::Matrix3d covariance_of(const std::vector<Pose2>& poses, const Pose2& mean) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Pose2& pose : poses) {
    const Pose2 off = motion_between(mean, pose);
    const Eigen::Vector3d error(off.x, off.y, off.theta);
    sum += error * error.transpose();
  }
  return sum / static_cast<double>(poses.size());
}

TEST(PriorAfter, LiesAtTheEndOfBothPartsOfTheMotion) {
  EXPECT_THAT(prior_after(kStart, kMotion, kErrors).mean,
              IsNear(kStart * kMotion.condensed * *kMotion.step, kExact));
}

TEST(PriorAfter, IsAsWideAsBothPartsDrawnOneAfterTheOther) {
  Rng rng(1);
  std::vector<Pose2> ends;
  for (int i = 0; i < 10'000; ++i) {
    const PosePrior first = gaussian_after(kStart, kMotion.condensed, kErrors.condensed);
    const Pose2 between = drawn_from(first.mean, first.information.inverse(), rng);
    const PosePrior second = gaussian_after(between, *kMotion.step, kErrors.odometry);
    ends.push_back(drawn_from(second.mean, second.information.inverse(), rng));
  }
  const PosePrior prior = prior_after(kStart, kMotion, kErrors);
  const Eigen::Matrix3d root = prior.information.llt().matrixL();
  const Eigen::Matrix3d whitened = root.transpose() * covariance_of(ends, prior.mean) * root;
  // Five times the sigma of a variance of so many draws, sqrt(2 / n).
  EXPECT_LT((whitened - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.07) << whitened;
}

// What is not known of the end of the condensed motion is not known of the end of the step.
TEST(PriorAfter, IsWiderByWhatIsNotKnownOfTheCondensedMotion) {
  UpdateMotion motion{.condensed = kMotion.condensed, .step = Pose2{}};
  const Eigen::Matrix3d known = prior_after(kStart, motion, kErrors).information.inverse();
  motion.condensed_doubt = Eigen::Vector3d(0.3 * 0.3, 0.1 * 0.1, 0.05 * 0.05).asDiagonal();
  const PosePrior prior = prior_after(kStart, motion, kErrors);
  EXPECT_TRUE((prior.information.inverse() - known).isApprox(*motion.condensed_doubt, 1e-9));
  EXPECT_THAT(prior.mean, IsNear(kStart * kMotion.condensed, kExact));
}

TEST(PriorAfter, ARefutedStepMayHaveEndedAnywhereInTheWindow) {
  UpdateMotion motion = kMotion;
  motion.step_contradicted = true;
  const PosePrior prior = prior_after(kStart, motion, kErrors);
  EXPECT_THAT(prior.mean, IsNear(kStart * motion.condensed * *motion.step, kExact));
  const Eigen::Matrix3d covariance = prior.information.inverse();
  // Beside them the condensed motion's sigmas, of some centimetres, do not count.
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), kErrors.contradicted_translation, 0.01);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), kErrors.contradicted_translation, 0.01);
  EXPECT_NEAR(std::sqrt(covariance(2, 2)), kErrors.contradicted_rotation, 0.01);
}

TEST(PriorAfter, WithoutOdometryTheStepWidensWithTime) {
  const auto sigma_after = [](double seconds) {
    const UpdateMotion motion{.condensed = kMotion.condensed, .step = {}, .seconds = seconds};
    const PosePrior prior = prior_after(kStart, motion, kErrors);
    EXPECT_THAT(prior.mean, IsNear(kStart * motion.condensed, kExact));
    const Eigen::Matrix3d before =
        gaussian_after(kStart, motion.condensed, kErrors.condensed).information.inverse();
    return std::sqrt((Eigen::Matrix3d(prior.information.inverse()) - before)(0, 0));
  };
  const MotionPriorOptions& blind = kErrors.blind;
  EXPECT_NEAR(sigma_after(1.0), blind.position_sigma + blind.speed_sigma, 1e-6);
  EXPECT_NEAR(sigma_after(3.0), blind.position_sigma + 3.0 * blind.speed_sigma, 1e-6);
}

TEST(DrawnFrom, ErrsInTheFrameOfTheMean) {
  const Eigen::Matrix3d forward = Eigen::Vector3d(0.04, 1e-12, 1e-12).asDiagonal();
  const Pose2 mean{1.0, 2.0, kPi / 2};  // forward is y
  Rng rng(1);
  std::vector<Pose2> drawn;
  for (int i = 0; i < 1000; ++i) {
    drawn.push_back(drawn_from(mean, forward, rng));
    EXPECT_NEAR(drawn.back().x, mean.x, 1e-5);
    EXPECT_NEAR(drawn.back().theta, mean.theta, 1e-5);
  }
  // Five times sqrt(2 / n) of the variance.
  EXPECT_NEAR(covariance_of(drawn, mean)(0, 0), 0.04, 0.04 * 0.22);
}

}  // namespace
}  // namespace mapbed
