#include "bench/faults/missed_turn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

constexpr Tolerance kRounding{1e-12, 1e-12};  // [m], [rad]

TEST(MissedTurn, IsTakenOutOfTheTurningOfTheRobot) {
  const BrokenLog broken = with_missed_turn(small_log(), {.turn = 1.5}, Rng(1));
  // The robot turns by 1 rad in each of its last three steps, so 1.5 rad in a row begin with the
  // first or the second of these, or with none other.
  ASSERT_EQ(broken.when.size(), 1U);
  const double from = broken.when[0].from;
  EXPECT_TRUE(from == 106.0 || from == 107.0);
  EXPECT_EQ(broken.when[0].to, from + 2.0);
  const std::vector<Pose2> steps = steps_of(broken.log);
  const auto first = static_cast<std::size_t>(from - 100.0);
  EXPECT_THAT(steps[first], IsNear(Pose2{0.0, 0.0, 0.0}, kRounding));
  EXPECT_THAT(steps[first + 1], IsNear(Pose2{0.0, 0.0, 0.5}, kRounding));
  EXPECT_THAT(readings_of(broken.log).back().odometry_from_robot,
              IsNear(Pose2{6.0, 0.0, 1.5}, kRounding));
}

TEST(MissedTurn, TakesTheLargestThereIsWhereNoneIsLargeEnough) {
  const BrokenLog broken = with_missed_turn(small_log(), {.turn = 3.5}, Rng(1));
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{106.0, 109.0}));
  EXPECT_THAT(readings_of(broken.log).back().odometry_from_robot,
              IsNear(Pose2{6.0, 0.0, 0.0}, kRounding));
}

TEST(MissedTurn, IsNoneOfARobotThatNeverTurns) {
  SensorLog log;
  for (int i = 0; i < 5; ++i) log.push_back(Odometry{1.0 * i, {1.0 * i, 0.0, 0.0}});
  const BrokenLog broken = with_missed_turn(log, {.turn = 0.5}, Rng(1));
  EXPECT_TRUE(are_same(broken.log, log));
  EXPECT_THAT(broken.when, ElementsAre());
}

}  // namespace
}  // namespace mapbed
