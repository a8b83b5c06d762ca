#include "algorithms/input/told_odometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

SensorLog log_of(const std::vector<Odometry>& readings) {
  return {readings.begin(), readings.end()};
}

TEST(ToldOdometry, IsKnownBetweenReadings) {
  const ToldOdometry odometry(
      log_of({{.time = 1.0}, {.time = 2.0, .odometry_from_robot = {1.0, 0.0, 0.4}}}));
  EXPECT_EQ(odometry.at(2.0), (Pose2{1.0, 0.0, 0.4}));
  EXPECT_NEAR(odometry.at(1.5)->theta, 0.2, 1e-12);
  EXPECT_NEAR(odometry.motion(1.25, 1.75)->theta, 0.2, 1e-12);
}

TEST(ToldOdometry, IsNotKnownOutsideOrInAGap) {
  const ToldOdometry odometry(log_of({{.time = 1.0}, {.time = 9.0}}));
  EXPECT_FALSE(odometry.at(0.5));
  EXPECT_FALSE(odometry.at(5.0));
  EXPECT_FALSE(odometry.at(9.5));
  EXPECT_FALSE(odometry.motion(1.0, 5.0));
  EXPECT_TRUE(odometry.motion(1.0, 9.0));
}

TEST(ToldOdometry, TellsWhereNobodyKnowsTheMotion) {
  const ToldOdometry odometry(log_of({{.time = 1.0}, {.time = 2.0, .motion_unknown = true}}));
  EXPECT_THAT(odometry.unknown(), ::testing::ElementsAre(2.0));
}

}  // namespace
}  // namespace mapbed
