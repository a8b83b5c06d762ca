#include "algorithms/motion/recent_motion.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::IsEmpty;

// Scans every 0.2 s of a robot that drives at 0.5 m/s or turns; odometry tells `told` of each step.
class RecentMotionTest : public ::testing::Test {
 protected:
  void go(int steps, const Pose2& step, double told = 1.0) {
    for (int i = 0; i < steps; ++i) {
      if (!std::exchange(first_, false)) {
        time_ += 0.2;
        pose_ = pose_ * step;
        odometry_ = odometry_ * interpolate({}, step, told);
      }
      recent_.add(time_, pose_, odometry_);
    }
  }
  // After a step that odometry tells thus.
  std::vector<PosePrior> elsewhere(const Pose2& told) const {
    return recent_.elsewhere(time_ + 0.2, odometry_ * told);
  }

  RecentMotion recent_{MotionPriorOptions{}};
  bool first_ = true;
  double time_ = 0.0;
  Pose2 pose_, odometry_;
};

TEST_F(RecentMotionTest, OfOdometryThatScansAgreeWithIsNowhereElse) {
  go(20, {0.1, 0.0, 0.0});
  EXPECT_THAT(elsewhere({0.1, 0.0, 0.0}), IsEmpty());
  go(20, {0.0, 0.0, 0.2});
  EXPECT_THAT(elsewhere({0.0, 0.0, 0.2}), IsEmpty());
}

// Wheels that count 5 % too much are nothing unusual.
TEST_F(RecentMotionTest, OfOdometryThatIsALittleWrongIsNowhereElse) {
  go(25, {0.1, 0.0, 0.0}, 1.05);
  EXPECT_THAT(elsewhere({0.105, 0.0, 0.0}), IsEmpty());
}

TEST_F(RecentMotionTest, HasTheRobotWhereItIsOnceOdometryCatchesUp) {
  const Pose2 step{0.0, 0.0, 0.3};
  go(10, step);
  go(5, step, 0.0);                               // odometry stands still
  const auto found = elsewhere({0.0, 0.0, 1.8});  // and tells all at once
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found.back().mean, IsNear(pose_ * step, Tolerance{1e-9, 1e-9}));
}

TEST_F(RecentMotionTest, LooksBackBySeconds) {
  const Pose2 step{0.0, 0.0, 0.3};
  go(5, step, 0.0);
  EXPECT_FALSE(elsewhere({}).empty());
  go(30, {});
  EXPECT_THAT(elsewhere({}), IsEmpty());
}

TEST_F(RecentMotionTest, KnowsNothingOfOneScan) {
  EXPECT_THAT(recent_.elsewhere(0.0, {}), IsEmpty());
  go(1, {});
  EXPECT_THAT(elsewhere({9.0, 0.0, 1.0}), IsEmpty());
}

}  // namespace
}  // namespace mapbed
