#include "bench/faults/drift.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

constexpr Tolerance kRounding{1e-12, 1e-12};  // [m], [rad]

TEST(Drift, TurnsByEveryMetreOfWay) {
  const BrokenLog broken = with_drift(small_log(), {.turn_per_meter = 0.1}, Rng(1));
  const std::vector<Pose2> steps = steps_of(broken.log);
  EXPECT_THAT(steps[0], IsNear(Pose2{1.0, 0.0, 0.1}, kRounding));
  EXPECT_THAT(steps[7], IsNear(Pose2{0.0, 0.0, 1.0}, kRounding)) << "on the spot";
  EXPECT_THAT(readings_of(broken.log)[6].odometry_from_robot.theta,
              ::testing::DoubleNear(0.6, 1e-12));
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{100.0, 109.0}));
}

}  // namespace
}  // namespace mapbed
