#include "bench/faults/restart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

constexpr Tolerance kRounding{1e-12, 1e-12};  // [m], [rad]

TEST(Restart, BeginsAgainAtZeroAndGoesOnFromThere) {
  const BrokenLog broken = with_restart(small_log(), {.enabled = true, .at = {4.5}}, Rng(1));
  const std::vector<Odometry> readings = readings_of(broken.log);
  EXPECT_EQ(readings[4].odometry_from_robot, (Pose2{4.0, 0.0, 0.0}));
  EXPECT_EQ(readings[5].odometry_from_robot, Pose2{});
  EXPECT_THAT(readings[6].odometry_from_robot, IsNear(Pose2{1.0, 0.0, 0.0}, kRounding));
  EXPECT_THAT(readings[8].odometry_from_robot, IsNear(Pose2{1.0, 0.0, 2.0}, kRounding));
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{104.0, 105.0}));
}

}  // namespace
}  // namespace mapbed
