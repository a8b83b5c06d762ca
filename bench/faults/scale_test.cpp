#include "bench/faults/scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

constexpr Tolerance kRounding{1e-12, 1e-12};  // [m], [rad]

TEST(Scale, MakesEveryStepLonger) {
  const BrokenLog broken = with_scale(small_log(), {.by = 0.1}, Rng(1));
  const std::vector<Odometry> readings = readings_of(broken.log);
  EXPECT_THAT(readings[6].odometry_from_robot, IsNear(Pose2{6.6, 0.0, 0.0}, kRounding));
  EXPECT_THAT(readings[8].odometry_from_robot, IsNear(Pose2{6.6, 0.0, 2.2}, kRounding));
  EXPECT_DOUBLE_EQ(readings[3].forward_velocity, 1.1);
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{100.0, 109.0}));
}

TEST(Scale, MakesThemShorterWhereItIsNegative) {
  const BrokenLog broken = with_scale(small_log(), {.by = -0.15}, Rng(1));
  EXPECT_THAT(readings_of(broken.log)[6].odometry_from_robot,
              IsNear(Pose2{5.1, 0.0, 0.0}, kRounding));
}

}  // namespace
}  // namespace mapbed
