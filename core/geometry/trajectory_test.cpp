#include "core/geometry/trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr Tolerance kRounding{1e-12, 1e-12};

TEST(Trajectory, HasAPoseAtItsStampsAndBetweenThem) {
  const Trajectory path{{1.0, {0, 0, 0}}, {2.0, {4, 0, 0}}, {4.0, {4, 2, 1}}};
  EXPECT_THAT(*pose_at(path, 1.0), IsNear(Pose2{0, 0, 0}, kRounding));
  EXPECT_THAT(*pose_at(path, 1.25), IsNear(Pose2{1, 0, 0}, kRounding));
  EXPECT_THAT(*pose_at(path, 2.0), IsNear(Pose2{4, 0, 0}, kRounding));
  EXPECT_THAT(*pose_at(path, 3.0), IsNear(Pose2{4, 1, 0.5}, kRounding));
  EXPECT_THAT(*pose_at(path, 4.0), IsNear(Pose2{4, 2, 1}, kRounding));
}

TEST(Trajectory, HasNoPoseBeforeItBeginsOrAfterItEnds) {
  const Trajectory path{{1.0, {0, 0, 0}}, {2.0, {4, 0, 0}}};
  EXPECT_FALSE(pose_at(path, 0.999));
  EXPECT_FALSE(pose_at(path, 2.001));
  EXPECT_FALSE(pose_at({}, 0.0));
}

TEST(Trajectory, IsAsLongAsItsStepsTogether) {
  EXPECT_DOUBLE_EQ(path_length({{0, {0, 0, 0}}, {1, {3, 4, 0}}, {2, {3, 4, 2}}, {3, {2, 4, 0}}}),
                   6.0);
  EXPECT_EQ(path_length({{0, {1, 2, 3}}}), 0.0);
  EXPECT_EQ(path_length({}), 0.0);
}

}  // namespace
}  // namespace mapbed
