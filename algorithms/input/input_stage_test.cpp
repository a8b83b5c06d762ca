#include "algorithms/input/input_stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

RecordedLog room_drive() {
  return drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
}

bool are_same(const Measurement& a, const Measurement& b) {
  if (a.index() != b.index() || time_of(a) != time_of(b)) return false;
  if (const auto* odometry = std::get_if<Odometry>(&a)) {
    return odometry->odometry_from_robot == std::get<Odometry>(b).odometry_from_robot;
  }
  return std::get<LaserScan>(a).ranges == std::get<LaserScan>(b).ranges;
}

TEST(InputStage, DoesNotChangeWhatIsInOrder) {
  const SensorLog log = room_drive().measurements;
  const PreparedLog ready = prepared(log);
  ASSERT_EQ(ready.log.size(), log.size());
  for (std::size_t i = 0; i < log.size(); ++i) EXPECT_TRUE(are_same(ready.log[i], log[i])) << i;
  EXPECT_TRUE(ready.remarks.empty());
}

// Scans of a front and a rear laser at each stamp, and odometry that the robot has driven.
SensorLog log_of_two_lasers(double rear_after) {
  SensorLog log;
  for (int i = 0; i < 30; ++i) {
    const double time = 0.2 * i;
    LaserScan scan{.time = time, .bearing_step = 0.02, .max_range = 8.0};
    scan.ranges.assign(100, 2.0 + 0.01 * i);
    log.push_back(Odometry{.time = time, .odometry_from_robot = {0.05 * i, 0.0, 0.0}});
    log.push_back(scan);
    scan.time += rear_after;
    scan.laser = 1;
    scan.robot_from_laser.planar = {-0.2, 0.0, kPi};
    log.push_back(scan);
  }
  return log;
}

TEST(InputStage, GivesOneScanForEachInstantOfSeveralLasers) {
  for (const double after : {0.0, 0.003}) {
    const PreparedLog ready = prepared(log_of_two_lasers(after));
    ASSERT_EQ(ready.log.size(), 60U);
    for (std::size_t i = 0; i < 60; i += 2) {
      EXPECT_TRUE(std::holds_alternative<Odometry>(ready.log[i]));
      const auto& scan = std::get<LaserScan>(ready.log[i + 1]);
      EXPECT_EQ(scan.time, time_of(ready.log[i]));
      EXPECT_EQ(scan.ranges.size(), 200U);
      EXPECT_EQ(scan.robot_from_beams.size(), 200U);
    }
    EXPECT_TRUE(ready.remarks.empty());
  }
}

TEST(InputStage, LeavesScansOfSeveralInstantsApart) {
  const PreparedLog ready = prepared(log_of_two_lasers(0.1));
  int scans = 0;
  for (const Measurement& measurement : ready.log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    ++scans;
    EXPECT_EQ(scan->ranges.size(), 100U);
  }
  EXPECT_EQ(scans, 60);
}

TEST(InputStage, TellsWhereTheRobotIsAtEachScanBetweenTwoReadings) {
  SensorLog log;
  for (int i = 0; i < 10; ++i) {
    log.emplace_back(Odometry{.time = 0.2 * i, .odometry_from_robot = {0.1 * i, 0.0, 0.0}});
    log.emplace_back(LaserScan{.time = 0.2 * i + 0.05, .max_range = 8.0, .ranges = {1.0 + i}});
  }
  const PreparedLog ready = prepared(std::move(log));
  for (std::size_t i = 1; i + 1 < ready.log.size(); ++i) {
    if (!std::holds_alternative<LaserScan>(ready.log[i])) continue;
    const auto& reading = std::get<Odometry>(ready.log[i - 1]);
    EXPECT_EQ(reading.time, time_of(ready.log[i]));
    EXPECT_NEAR(reading.odometry_from_robot.x, 0.5 * reading.time, 1e-9);
  }
}

// Sweeps of 0.15 s of a robot that turns; odometry ten times a second.
TEST(InputStage, HoldsSweepsBackUntilOdometryReachesTheirEnd) {
  InputStage stage;
  SensorLog out;
  const auto add = [&](Measurement measurement) {
    for (Measurement& ready : stage.add(std::move(measurement))) out.push_back(std::move(ready));
  };
  for (int i = 0; i < 20; ++i) {
    const double time = 0.1 * i;
    add(Odometry{.time = time, .odometry_from_robot = {0.0, 0.0, 0.1 * i}});
    if (i % 2 == 1) continue;
    LaserScan scan{.time = time, .bearing_step = 0.02, .beam_period = 0.0015, .max_range = 8.0};
    for (int beam = 0; beam < 101; ++beam) scan.ranges.push_back(2.0 + 0.001 * i + 0.01 * beam);
    add(scan);
  }
  for (Measurement& ready : stage.finish()) out.push_back(std::move(ready));
  ASSERT_EQ(out.size(), 30U);
  for (std::size_t i = 1; i < out.size(); ++i) EXPECT_LE(time_of(out[i - 1]), time_of(out[i]));
  for (const Measurement& measurement : out) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scan->time > 1.75) continue;  // no odometry after the last one
    ASSERT_EQ(scan->robot_from_beams.size(), 101U);
    // The last beam: 0.15 s later, at 1 rad/s.
    EXPECT_NEAR(scan->robot_from_beams.back().theta, 100 * 0.02 + 0.15, 1e-9);
  }
}

// Turns now and then, and takes its beams one after the other: a lag of odometry would explain a
// part of it.
TEST(InputStage, DoesNotTakeASweepForALagOfOdometry) {
  const TestRoom room = furnished_room();
  const auto pose = [](double time) {
    const double turned = std::floor(time / 2.0) + std::clamp(std::fmod(time, 2.0) - 1.0, 0.0, 1.0);
    return Pose2{0.5, 0.2, normalized_angle(1.5 * turned)};
  };
  SensorLog log;
  for (int i = 0; i < 120; ++i) {
    const double time = 0.18 * i;
    LaserScan scan{
        .time = time, .first_bearing = -kPi, .bearing_step = kPi / 60.0, .max_range = 20.0};
    for (std::size_t beam = 0; beam < 120; ++beam) {
      const Pose2 here = pose(time + 0.0015 * static_cast<double>(beam));
      scan.ranges.push_back(
          room.distance_to_wall(here.position(), here.theta + scan.bearing(beam)));
    }
    log.push_back(Odometry{.time = time, .odometry_from_robot = pose(time)});
    log.push_back(std::move(scan));
  }
  const PreparedLog ready = prepared(std::move(log));
  ASSERT_EQ(ready.remarks.size(), 1U);
  EXPECT_EQ(ready.remarks[0].kind, RemarkKind::skewed_sweep);
}

TEST(InputStage, TakesAnEmptyLog) {
  EXPECT_TRUE(prepared({}).log.empty());
}

// Looks into all directions.
SensorLog long_drive() {
  return drive_through(furnished_room(),
                       {{-3, 0}, {3, 0}, {3, 2}, {-2, 2}, {-2, -2}, {2, -2.5}, {2, 1}, {-2, -1}},
                       {.scan_period = 0.5}, Rng(3))
      .measurements;
}

std::vector<RemarkKind> kinds_of(const std::vector<Remark>& remarks) {
  std::vector<RemarkKind> kinds;
  for (const Remark& remark : remarks) kinds.push_back(remark.kind);
  return kinds;
}

TEST(InputStage, LeavesOutBeamsThatAreBlocked) {
  SensorLog log = long_drive();
  for (Measurement& m : log) {
    auto* scan = std::get_if<LaserScan>(&m);
    for (std::size_t beam = 0; scan != nullptr && beam < 40; ++beam) scan->ranges[beam] = 0.2;
  }
  const PreparedLog ready = prepared(std::move(log));
  EXPECT_EQ(kinds_of(ready.remarks), std::vector{RemarkKind::blocked_beams});
  for (const Measurement& m : ready.log) {
    const auto* scan = std::get_if<LaserScan>(&m);
    for (std::size_t beam = 0; scan != nullptr && beam < 41; ++beam) {
      EXPECT_EQ(scan->ranges[beam] > 0.0, beam == 40);
    }
  }
}

TEST(InputStage, PutsScansInTheOrderInWhichTheyWereTaken) {
  const SensorLog right = long_drive();
  SensorLog log = right;
  std::vector<LaserScan*> scans;
  for (Measurement& m : log) {
    if (auto* scan = std::get_if<LaserScan>(&m)) scans.push_back(scan);
  }
  std::swap(*scans[20], *scans[21]);
  std::swap(scans[20]->time, scans[21]->time);
  const PreparedLog ready = prepared(std::move(log));
  EXPECT_EQ(kinds_of(ready.remarks), std::vector{RemarkKind::stamp_order});
  ASSERT_EQ(ready.log.size(), right.size());
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_TRUE(are_same(ready.log[i], right[i])) << i;
}

// Whoever prepares a log, also one that was broken on purpose, is told.
TEST(InputStage, TellsOfBeamsThatDoNotLookWhereTheLogSays) {
  SensorLog log = long_drive();
  for (Measurement& m : log) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) continue;
    scan->first_bearing = -scan->first_bearing;
    scan->bearing_step = -scan->bearing_step;
  }
  EXPECT_EQ(kinds_of(prepared(std::move(log)).remarks), std::vector{RemarkKind::laser_mount});
}

}  // namespace
}  // namespace mapbed
