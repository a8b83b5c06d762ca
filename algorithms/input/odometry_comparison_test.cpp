#include "algorithms/input/odometry_comparison.h"

#include <functional>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A drive of a minute, five scans a second: straight on for 4 s, a quarter turn in 2 s, and so on.
// The estimate is right; odometry tells what `told` makes of each step.
struct Drive {
  SensorLog log;
  Trajectory estimate;
};
using TellStep = std::function<Pose2(double time, const Pose2& step)>;
Drive drive(const TellStep& told) {
  constexpr double kStep = 0.2;  // [s]
  Drive drive;
  Pose2 pose, odometry;
  for (int i = 0; i <= 300; ++i) {
    const double time = 100.0 + kStep * i;
    const bool turns = i % 30 >= 20;
    const Pose2 step = i == 0 ? Pose2{} : turns ? Pose2{0.0, 0.0, 0.157} : Pose2{0.1, 0.0, 0.0};
    pose = pose * step;
    odometry = odometry * told(time, step);
    drive.log.emplace_back(Odometry{.time = time, .odometry_from_robot = odometry});
    drive.estimate.push_back({time, pose});
  }
  return drive;
}

std::vector<RemarkKind> kinds(const Drive& drive) {
  std::vector<RemarkKind> result;
  for (const Remark& remark : remarks_on_odometry(drive.log, drive.estimate)) {
    result.push_back(remark.kind);
  }
  return result;
}

TEST(RemarksOnOdometry, AreNoneWhereItIsAsGoodAsUsual) {
  EXPECT_THAT(kinds(drive([](double, const Pose2& step) { return step; })), IsEmpty());
  EXPECT_THAT(kinds(drive([](double, const Pose2& step) {
                return Pose2{1.05 * step.x, 0.0, 1.05 * step.theta + 0.02 * step.x};
              })),
              IsEmpty());
}

TEST(RemarksOnOdometry, NameAStallByItsTime) {
  const auto stalls = [](double from, double to) {
    return drive([=, kept = Pose2{}](double time, const Pose2& step) mutable {
      kept = kept * step;
      if (time > from && time < to) return Pose2{};
      return std::exchange(kept, Pose2{});
    });
  };
  for (const double from : {104.1, 108.1, 120.5}) {
    const Drive broken = stalls(from, from + 1.0);
    const std::vector<Remark> remarks = remarks_on_odometry(broken.log, broken.estimate);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0].kind, RemarkKind::odometry_stall);
    EXPECT_NEAR(remarks[0].when->from, from, 0.3);
    EXPECT_NEAR(remarks[0].when->to, from + 1.0, 0.3);
  }
}

// 18 cm in 12 s, as with people about.
TEST(RemarksOnOdometry, AreNoneWhereTheEstimateOfARobotThatStandsCreeps) {
  Drive waits;
  Pose2 pose, odometry;
  for (int i = 0; i <= 300; ++i) {
    const double time = 100.0 + 0.2 * i;
    const bool stands = i > 100 && i <= 160;
    pose = pose * Pose2{stands ? 0.003 : 0.1, 0.0, 0.0};
    if (!stands) odometry = odometry * Pose2{0.1, 0.0, 0.0};
    waits.log.emplace_back(Odometry{.time = time, .odometry_from_robot = odometry});
    waits.estimate.push_back({time, pose});
  }
  EXPECT_THAT(kinds(waits), IsEmpty());
}

TEST(RemarksOnOdometry, NameAMissedTurn) {
  EXPECT_THAT(kinds(drive([](double time, const Pose2& step) {
                return time > 104.1 && time < 106.1 ? Pose2{} : step;
              })),
              ElementsAre(RemarkKind::odometry_slip));
}

TEST(RemarksOnOdometry, NameWheelsThatSpin) {
  EXPECT_THAT(kinds(drive([](double time, const Pose2& step) {
                return time > 112.0 && time < 114.0 ? Pose2{step.x + 0.3, 0.0, step.theta} : step;
              })),
              ElementsAre(RemarkKind::odometry_slip));
}

TEST(RemarksOnOdometry, NameAConstantErrorOfTheWay) {
  for (const double factor : {0.8, 1.2}) {
    EXPECT_THAT(kinds(drive([&](double, const Pose2& step) {
                  return Pose2{factor * step.x, 0.0, step.theta};
                })),
                ElementsAre(RemarkKind::odometry_scale));
  }
}

TEST(RemarksOnOdometry, NameADrift) {
  EXPECT_THAT(kinds(drive([](double, const Pose2& step) {
                return Pose2{step.x, 0.0, step.theta + 0.1 * step.x};
              })),
              ElementsAre(RemarkKind::odometry_drift));
}

TEST(RemarksOnOdometry, NameStampsThatAreLateOrEarly) {
  for (const double lag : {0.2, 0.4, -0.2}) {
    Drive late = drive([](double, const Pose2& step) { return step; });
    for (Measurement& measurement : late.log) std::get<Odometry>(measurement).time += lag;
    EXPECT_THAT(kinds(late), ElementsAre(RemarkKind::odometry_lag)) << lag;
  }
}

// The estimate's robot is turned by as much as the laser is.
TEST(RemarksOnOdometry, NameALaserThatDoesNotLookWhereTheLogSays) {
  for (const double turned : {0.05, -0.09}) {
    Drive askew = drive([](double, const Pose2& step) { return step; });
    for (Stamped<Pose2>& stamped : askew.estimate) stamped.pose.theta += turned;
    EXPECT_THAT(kinds(askew), ElementsAre(RemarkKind::laser_mount)) << turned;
  }
}

TEST(RemarksOnOdometry, AreNoneWithoutOdometry) {
  const Drive right = drive([](double, const Pose2& step) { return step; });
  EXPECT_THAT(remarks_on_odometry({}, right.estimate), IsEmpty());
  EXPECT_THAT(remarks_on_odometry(right.log, {}), IsEmpty());
}

}  // namespace
}  // namespace mapbed
