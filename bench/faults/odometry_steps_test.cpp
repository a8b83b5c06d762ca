#include "bench/faults/odometry_steps.h"

#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

TEST(OdometrySteps, ToldAsTheyAreLeaveTheLogAsItIs) {
  const SensorLog log =
      with_steps(small_log(), [](const OdometryStep& step) { return step.motion; });
  EXPECT_TRUE(are_same(log, small_log()));
}

TEST(OdometrySteps, ToldOtherwiseMoveAllThatComesAfter) {
  const SensorLog log = with_steps(small_log(), [](const OdometryStep& step) {
    return step.from == 102.0 ? Pose2{0.5, 0.0, 0.0} : step.motion;
  });
  EXPECT_EQ(readings_of(log)[2].odometry_from_robot, (Pose2{2.0, 0.0, 0.0}));
  EXPECT_EQ(readings_of(log)[3].odometry_from_robot, (Pose2{2.5, 0.0, 0.0}));
  EXPECT_THAT(readings_of(log)[9].odometry_from_robot,
              IsNear(Pose2{5.5, 0.0, 3.0}, Tolerance{1e-12, 1e-12}));
}

}  // namespace
}  // namespace mapbed
