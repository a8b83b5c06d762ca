#include "bench/faults/jump.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Jump, IsOneStepThatIsTooLongAndTurned) {
  const JumpOptions options{.distance = 0.5, .turn = 0.3, .at = {2.5}};
  const BrokenLog broken = with_jump(small_log(), options, Rng(1));
  const std::vector<Pose2> steps = steps_of(broken.log);
  const std::vector<Pose2> clean = steps_of(small_log());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Pose2 more = motion_between(clean[i], steps[i]);
    EXPECT_NEAR(std::hypot(more.x, more.y), i == 2 ? 0.5 : 0.0, 1e-12);
    EXPECT_NEAR(more.theta, i == 2 ? 0.3 : 0.0, 1e-12);
  }
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{102.0, 103.0}));
}

TEST(Jump, MayComeSeveralTimes) {
  const JumpOptions options{.turn = 0.1, .at = {5.5, 1.5}};
  const BrokenLog broken = with_jump(small_log(), options, Rng(1));
  EXPECT_THAT(readings_of(broken.log)[6].odometry_from_robot.theta, DoubleNear(0.2, 1e-12));
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{101.0, 102.0}, TimeInterval{105.0, 106.0}));
}

}  // namespace
}  // namespace mapbed
