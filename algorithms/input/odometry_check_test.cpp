#include "algorithms/input/odometry_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Tolerance kExact{1e-9, 1e-9};

// Straight on at 0.5 m/s, ten readings a second, as `change` makes them.
template <class Change>
std::vector<Odometry> checked_drive(OdometryCheck& check, int readings, Change&& change) {
  std::vector<Odometry> result;
  for (int i = 0; i < readings; ++i) {
    Odometry reading{.time = 10.0 + 0.1 * i, .odometry_from_robot = {2.0 + 0.05 * i, 1.0, 0.0}};
    change(i, reading);
    result.push_back(check.checked(reading));
  }
  return result;
}

TEST(OdometryCheck, LeavesWhatIsInOrderAsItIs) {
  OdometryCheck check;
  const auto drive = checked_drive(check, 30, [](int, Odometry&) {});
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(drive[static_cast<std::size_t>(i)].odometry_from_robot, (Pose2{2.0 + 0.05 * i, 1.0}));
    EXPECT_FALSE(drive[static_cast<std::size_t>(i)].motion_unknown);
  }
  EXPECT_THAT(check.remarks(10.0), IsEmpty());
}

TEST(OdometryCheck, GoesOnAsBeforeOverAJumpOfTheCounters) {
  OdometryCheck check;
  const auto drive = checked_drive(check, 10, [](int i, Odometry& reading) {
    if (i >= 5) reading.odometry_from_robot = Pose2{-7.0, 3.0, 2.0} * reading.odometry_from_robot;
  });
  EXPECT_THAT(drive.back().odometry_from_robot, IsNear(Pose2{2.45, 1.0, 0.0}, kExact));
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(drive[static_cast<std::size_t>(i)].motion_unknown, i == 5) << i;
  }
  const std::vector<Remark> remarks = check.remarks(10.0);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0].kind, RemarkKind::odometry_jump);
  EXPECT_EQ(remarks[0].when, (TimeInterval{10.5, 10.5}));
}

TEST(OdometryCheck, TakesOutASingleWildReading) {
  OdometryCheck check;
  const auto drive = checked_drive(check, 10, [](int i, Odometry& reading) {
    if (i == 4) reading.odometry_from_robot.x = 1e6;
  });
  EXPECT_THAT(drive.back().odometry_from_robot,
              IsNear(Pose2{2.45, 1.0, 0.0}, Tolerance{1e-6, 1e-9}));
}

// After a pause the robot is taken to stand where it was.
TEST(OdometryCheck, CountersThatBeginAgainAtZeroInAPauseAreTold) {
  for (const double pause : {0.0, 10.0, 600.0}) {
    OdometryCheck check;
    const auto drive = checked_drive(check, 10, [pause](int i, Odometry& reading) {
      if (i < 5) return;
      reading.time += pause;
      reading.odometry_from_robot = {0.05 * (i - 5), 0.0, 0.0};
    });
    const double meanwhile = pause == 0.0 ? 0.05 : 0.0;
    EXPECT_THAT(drive.back().odometry_from_robot, IsNear(Pose2{2.4 + meanwhile, 1.0, 0.0}, kExact));
    const std::vector<Remark> remarks = check.remarks(10.0);
    ASSERT_EQ(remarks.size(), 1U) << pause;
    EXPECT_EQ(remarks[0].kind, RemarkKind::odometry_restart);
    EXPECT_DOUBLE_EQ(remarks[0].when->from, 10.5 + pause);
    EXPECT_THAT(remarks[0].text, HasSubstr("odometry begins again"));
  }
}

TEST(OdometryCheck, CountersThatBeginAgainWhereTheLogBeganAreTold) {
  OdometryCheck check;
  const auto drive = checked_drive(check, 40, [](int i, Odometry& reading) {
    if (i >= 30) reading.odometry_from_robot = {2.0 + 0.05 * (i - 30), 1.0, 0.0};
  });
  EXPECT_TRUE(drive[30].motion_unknown);
  EXPECT_THAT(check.remarks(10.0),
              ElementsAre(::testing::Field(&Remark::kind, RemarkKind::odometry_restart)));
}

// Out and back again to where the log began, to the last bit.
TEST(OdometryCheck, ARobotThatComesHomeHasNotRestarted) {
  OdometryCheck check;
  for (int i = 0; i <= 40; ++i) {
    const int out = i <= 20 ? i : 40 - i;
    check.checked({.time = 0.1 * i, .odometry_from_robot = {0.04 * out, 0.0, 0.0}});
  }
  EXPECT_THAT(check.remarks(0.0), IsEmpty());
}

// Of two readings that lie so far apart.
bool jumps(const Pose2& step, const OdometryCheckOptions& options, double seconds = 0.5) {
  OdometryCheck check(options);
  check.checked({.time = 0.0});
  check.checked({.time = seconds, .odometry_from_robot = step});
  return !check.remarks(0.0).empty();
}

TEST(OdometryCheck, OdometryThatIsTooFastHasJumped) {
  EXPECT_FALSE(jumps({0.9, 0.0, 0.0}, {.max_speed = 2.0}));
  EXPECT_TRUE(jumps({0.8, 0.8, 0.0}, {.max_speed = 2.0}));
}

TEST(OdometryCheck, OdometryThatTurnsTooFastHasJumped) {
  EXPECT_FALSE(jumps({0.0, 0.0, -0.9}, {.max_turn_rate = 2.0}));
  EXPECT_TRUE(jumps({0.0, 0.0, -1.1}, {.max_turn_rate = 2.0}));
  EXPECT_TRUE(jumps({0.0, 0.0, 1.75}, {}, 0.25));  // 7 rad/s
}

// Stamps may be off, as where a driver hands out readings in bunches.
TEST(OdometryCheck, ReadingsWithNearlyTheSameStampHaveNotJumped) {
  EXPECT_FALSE(jumps({0.2, 0.0, 0.1}, {.max_speed = 1.0, .max_turn_rate = 1.0}, 0.001));
}

// 0.5 m within a tenth of a second, which a fast robot may do: not this one.
TEST(OdometryCheck, KnowsAJumpByTheLogsOwnMotion) {
  SensorLog log;
  for (int i = 0; i < 200; ++i) {
    const double jump = i < 70 ? 0.0 : 0.5;
    log.push_back(Odometry{.time = 0.1 * i, .odometry_from_robot = {0.05 * i + jump, 0.0, 0.0}});
  }
  OdometryCheck alone, knowing({}, usual_motion(log));
  for (const Measurement& measurement : log) {
    alone.checked(std::get<Odometry>(measurement));
    knowing.checked(std::get<Odometry>(measurement));
  }
  EXPECT_THAT(alone.remarks(0.0), IsEmpty());
  EXPECT_EQ(knowing.remarks(0.0).size(), 1U);
}

// What it tells then is motion.
TEST(OdometryCheck, OdometryThatStallsAndCatchesUpHasNotJumped) {
  SensorLog log;
  for (int i = 0; i < 200; ++i) {
    const int told = i >= 100 && i < 120 ? 100 : i;
    log.push_back(
        Odometry{.time = 0.1 * i, .odometry_from_robot = {0.05 * told, 0.0, 0.005 * told}});
  }
  OdometryCheck check({}, usual_motion(log));
  for (const Measurement& measurement : log) check.checked(std::get<Odometry>(measurement));
  EXPECT_THAT(texts_of(check.remarks(0.0)), IsEmpty());
}

}  // namespace
}  // namespace mapbed
