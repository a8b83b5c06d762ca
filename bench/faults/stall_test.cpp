#include "bench/faults/stall.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

TEST(Stall, HoldsOdometryAndThenCatchesUpInOneStep) {
  const BrokenLog broken = with_stall(small_log(), {.duration = 2.5, .at = {2.0}}, Rng(1));
  // Readings at 0, 1, 2, 3, …: those at 3 and 4 are held at 2 m, that at 5 is where it was.
  const std::vector<Odometry> readings = readings_of(broken.log);
  EXPECT_EQ(readings[3].odometry_from_robot, (Pose2{2.0, 0.0, 0.0}));
  EXPECT_EQ(readings[4].odometry_from_robot, (Pose2{2.0, 0.0, 0.0}));
  EXPECT_EQ(readings[4].forward_velocity, 0.0);
  EXPECT_EQ(readings[5].odometry_from_robot, (Pose2{5.0, 0.0, 0.0}));
  EXPECT_EQ(readings[5].forward_velocity, 1.0);
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{102.0, 104.5}));
}

TEST(Stall, IsNoneBetweenTwoReadings) {
  const BrokenLog broken = with_stall(small_log(), {.duration = 0.5, .at = {2.0}}, Rng(1));
  EXPECT_TRUE(are_same(broken.log, small_log()));
  EXPECT_THAT(broken.when, ElementsAre());
}

TEST(Stall, StrikesWhileTheRobotMoves) {
  SensorLog log;  // stands for 20 s, drives 1 m in each of the next two, stands again
  for (int i = 0; i <= 40; ++i) {
    log.push_back(Odometry{1.0 * i, {std::clamp(i - 20.0, 0.0, 2.0), 0.0, 0.0}});
  }
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const BrokenLog broken = with_stall(log, {.duration = 1.5}, Rng(seed));
    ASSERT_EQ(broken.when.size(), 1U);
    EXPECT_GE(broken.when[0].from, 20.0);
    EXPECT_LE(broken.when[0].from, 21.0);
  }
}

}  // namespace
}  // namespace mapbed
