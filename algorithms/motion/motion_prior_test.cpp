#include "algorithms/motion/motion_prior.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

Eigen::Vector3d variances(const Eigen::Matrix3d& information) {
  return information.inverse().diagonal();
}

TEST(MotionPrior, IsWorthTheSameHoweverManyScansCutAMotion) {
  const PosePrior whole = predict({}, {1.0, 0.0, 0.4}, 0.8, {});
  const PosePrior quarter = predict({}, {0.25, 0.0, 0.1}, 0.2, {});
  EXPECT_TRUE(variances(whole.information).isApprox(4.0 * variances(quarter.information), 1e-9));
  EXPECT_TRUE(variances(whole.tail).isApprox(4.0 * variances(quarter.tail), 1e-9));
}

TEST(MotionPrior, IsSharpNearOdometryAndForgivesASlip) {
  MotionPriorOptions options;
  options.odometry = {.position_per_time = 0.01, .heading_per_time = 0.1};
  options.slip = {.position_per_time = 0.1, .heading_per_time = 0.1};
  options.slip_share = 0.2;
  const PosePrior prior = predict({}, {}, 1.0, options);
  EXPECT_NEAR(prior.log_at({0.01, 0.0, 0.0}), -0.5, 1e-9);
  EXPECT_EQ(prior.information_at({0.01, 0.0, 0.0}), prior.information);
  // 20 sigmas off: the slip's Gaussian, a hundredth as high at the mean and a quarter as often.
  const double slip = std::log(0.25 * 0.01) - 0.5 * 4.0;
  EXPECT_NEAR(prior.log_at({0.2, 0.0, 0.0}), slip, 1e-9);
  EXPECT_EQ(prior.information_at({0.2, 0.0, 0.0}), prior.tail);
}

TEST(MotionPrior, OfARobotThatStandsIsThatOfASecondAtMost) {
  const PosePrior second = predict({}, {}, 1.0, {}), hour = predict({}, {}, 3600.0, {});
  EXPECT_EQ(second.information, hour.information);
}

}  // namespace
}  // namespace mapbed
