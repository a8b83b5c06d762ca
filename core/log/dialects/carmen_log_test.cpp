#include "core/log/dialects/carmen_log.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const LaserScan& scan_at(const RecordedLog& log, std::size_t index) {
  return std::get<LaserScan>(log.measurements.at(index));
}

const Odometry& odometry_at(const RecordedLog& log, std::size_t index) {
  return std::get<Odometry>(log.measurements.at(index));
}

std::string flaser(int beams, double range, double time) {
  std::string line = fmt::format("FLASER {}", beams);
  for (int i = 0; i < beams; ++i) line += fmt::format(" {}", range);
  return line + fmt::format(" 9 9 9 1 2 0.5 {} host 7\n", time);
}

const std::string kRobotLaser =
    "ROBOTLASER1 3 -1.5 3 0.75 50 0.1 1 5 1.5 2 3 4 81.9 5 10 20 30 40 50 "
    "1.5 2 0.1 1 2 0.1 0.3 -0.2 0 0 0 100.25 host 0.5\n";

TEST(CarmenLog, AnFlaserLineIsOdometryAndThenAScanOfTheSameStamp) {
  const RecordedLog log = parse_log("a.log", flaser(181, 3.25, 12.5));
  ASSERT_EQ(log.measurements.size(), 2u);
  EXPECT_EQ(odometry_at(log, 0).time, 12.5);
  EXPECT_THAT(odometry_at(log, 0).odometry_from_robot, IsNear(Pose2{1, 2, 0.5}, Tolerance{0, 0}));
  const LaserScan& scan = scan_at(log, 1);
  EXPECT_EQ(scan.time, 12.5);
  EXPECT_EQ(scan.ranges, std::vector<double>(181, 3.25));
  EXPECT_EQ(scan.first_bearing, -kPi / 2);
  EXPECT_EQ(scan.bearing_step, radians(1.0));
  EXPECT_EQ(log.format, "CARMEN");
  EXPECT_TRUE(log.has_stamps);
  EXPECT_TRUE(log.warnings.empty());
}

TEST(CarmenLog, TheLoggersStampIsTakenOnRequest) {
  const RecordedLog log = parse_log("a.log", flaser(181, 3.25, 12.5), {.stamp = Stamp::logger});
  EXPECT_EQ(scan_at(log, 1).time, 7.0);
}

TEST(CarmenLog, ARobotlaserLineHasItsOwnGeometryAndVelocities) {
  const RecordedLog log = parse_log("a.log", kRobotLaser);
  const Odometry& odometry = odometry_at(log, 0);
  EXPECT_EQ(odometry.forward_velocity, 0.3);
  EXPECT_EQ(odometry.turn_velocity, -0.2);
  const LaserScan& scan = scan_at(log, 1);
  EXPECT_EQ(scan.time, 100.25);
  EXPECT_EQ(scan.first_bearing, -1.5);
  EXPECT_EQ(scan.bearing_step, 0.75);
  EXPECT_THAT(scan.ranges, ElementsAre(1.5, 2, 3, 4, 81.9));
  EXPECT_THAT(scan.remissions, ElementsAre(10, 20, 30, 40, 50));
  EXPECT_THAT(scan.robot_from_laser.planar,
              IsNear(Pose2{0.5 * std::cos(0.1), -0.5 * std::sin(0.1), 0}, Tolerance{1e-6, 1e-6}));
  EXPECT_TRUE(scan.is_max_range(4));
  EXPECT_EQ(scan.max_range, 50.0);
}

// 180 beams are 181 of half a turn without the last one.
TEST(CarmenLog, AnEvenNumberOfBeamsLacksTheLastOne) {
  const RecordedLog log = parse_log("a.log", flaser(180, 3.25, 12.5));
  EXPECT_EQ(scan_at(log, 1).first_bearing, -kPi / 2);
  EXPECT_EQ(scan_at(log, 1).bearing_step, radians(1.0));
}

TEST(CarmenLog, ARearLaserLooksBack) {
  std::string line = flaser(181, 3.25, 12.5);
  line[0] = 'R';
  const RecordedLog log = parse_log("a.log", "PARAM robot_rearlaser_offset -0.3 host 0\n" + line);
  EXPECT_EQ(scan_at(log, 1).laser, 1);
  EXPECT_THAT(scan_at(log, 1).robot_from_laser.planar,
              IsNear(Pose2{-0.3, 0, kPi}, Tolerance{1e-12, 1e-12}));
}

TEST(CarmenLog, ReadsOdometryTruthParametersAndPassesOverTheRest) {
  const RecordedLog log = parse_log("a.log",
                                    "# a comment\r\nPARAM robot_frontlaser_offset 0.2 host 0\r\n"
                                    "ODOM 1 2 0.5 0.3 0.1 0 12 host 0\r\nSYNC tag 12 host 0\r\n"
                                    "TRUEPOS 5 6 7 1 2 0.5 12.25 host 0\r\nNEFF 60\nNEFF 50\n" +
                                        flaser(181, 3.0, 12.5));
  ASSERT_EQ(log.measurements.size(), 3u);
  EXPECT_EQ(odometry_at(log, 0).forward_velocity, 0.3);
  EXPECT_EQ(odometry_at(log, 0).turn_velocity, 0.1);
  ASSERT_EQ(log.true_poses.size(), 1u);
  EXPECT_EQ(log.true_poses[0].time, 12.25);
  EXPECT_THAT(log.true_poses[0].pose, IsNear(Pose2{5, 6, 7 - 2 * kPi}, Tolerance{0, 1e-12}));
  EXPECT_EQ(scan_at(log, 2).robot_from_laser.planar.x, 0.2);
  EXPECT_EQ(log.parameters.at("robot_frontlaser_offset"), "0.2");
  ASSERT_EQ(log.warnings.size(), 2u);
  EXPECT_EQ(to_string(log.warnings[0]), "a.log:4: SYNC messages are not used");
  EXPECT_EQ(to_string(log.warnings[1]), "a.log:6: NEFF messages are not used (2 times)");
}

TEST(CarmenLog, RawLaserLinesCountOnlyWhereNoOtherLaserLineIs) {
  const std::string raw = "RAWLASER1 0 -1 2 1 50 0.1 0 3 1 2 3 0 100.25 host 0\n";
  const RecordedLog alone = parse_log("a.log", raw);
  ASSERT_EQ(alone.measurements.size(), 1u);
  EXPECT_THAT(scan_at(alone, 0).ranges, ElementsAre(1, 2, 3));
  EXPECT_EQ(parse_log("a.log", raw + kRobotLaser + raw).measurements.size(), 2u);
}

TEST(CarmenLog, AStampOfZeroIsThatOfTheLineBefore) {
  const RecordedLog log =
      parse_log("a.log", flaser(181, 3.0, 12.5) + "ODOM 1 2 0.5 0 0 0 0 host 0\n");
  EXPECT_EQ(odometry_at(log, 2).time, 12.5);
  EXPECT_EQ(to_string(log.warnings.at(0)),
            "a.log:2: no time stamp: that of the line before is taken");
}

// Of lasers that scan at one moment the odometry is one reading; a laser's own lines are two.
TEST(CarmenLog, EachLineOfOneLaserHasItsOdometry) {
  EXPECT_EQ(parse_log("a.log", kRobotLaser + kRobotLaser).measurements.size(), 4u);
  std::string rear = kRobotLaser;
  rear.replace(rear.find('1'), 1, "2");
  EXPECT_EQ(parse_log("a.log", kRobotLaser + rear).measurements.size(), 3u);
}

TEST(CarmenLog, TheOldestLogsHaveOneStampOnly) {
  const RecordedLog log =
      parse_log("a.log", "FLASER 5 1 2 3 4 5 0 0 0 1 2 0.5 12.5", {.field_of_view = kPi});
  EXPECT_EQ(scan_at(log, 1).time, 12.5);
}

RecordedLog drive(const TestLaser& laser = {}) {
  DriveOptions options;
  options.laser = laser;
  return drive_through(rectangular_room(6, 4), {{-2, 0}, {1, 0}, {1, 1}}, options, Rng(4));
}

void expect_equal(const RecordedLog& read, const RecordedLog& written) {
  ASSERT_EQ(read.measurements.size(), written.measurements.size());
  EXPECT_EQ(read.true_poses.size(), written.true_poses.size());
  for (std::size_t i = 0; i < read.true_poses.size(); ++i) {
    EXPECT_EQ(read.true_poses[i].time, written.true_poses[i].time);
    EXPECT_EQ(read.true_poses[i].pose, written.true_poses[i].pose);
  }
  for (std::size_t i = 0; i < read.measurements.size(); ++i) {
    EXPECT_EQ(time_of(read.measurements[i]), time_of(written.measurements[i]));
    if (const auto* odometry = std::get_if<Odometry>(&written.measurements[i])) {
      EXPECT_EQ(odometry_at(read, i).odometry_from_robot, odometry->odometry_from_robot);
      continue;
    }
    const LaserScan& a = scan_at(read, i);
    const LaserScan& b = scan_at(written, i);
    EXPECT_EQ(a.ranges, b.ranges);
    EXPECT_EQ(a.laser, b.laser);
    EXPECT_EQ(a.remissions, b.remissions);
    EXPECT_EQ(a.beam_period, b.beam_period);
    EXPECT_EQ(a.max_range, b.max_range);
    EXPECT_NEAR(a.first_bearing, b.first_bearing, 1e-14);
    EXPECT_NEAR(a.bearing_step, b.bearing_step, 1e-15);
    EXPECT_THAT(a.robot_from_laser.planar,
                IsNear(b.robot_from_laser.planar, Tolerance{1e-12, 1e-12}));
    EXPECT_EQ(a.robot_from_laser.z, b.robot_from_laser.z);
    EXPECT_EQ(a.robot_from_laser.pitch, b.robot_from_laser.pitch);
    EXPECT_EQ(a.robot_from_laser.roll, b.robot_from_laser.roll);
  }
}

TEST(CarmenLog, WhatWasWrittenReadsBackTheSame) {
  RecordedLog log = drive({.beams = 97,
                           .first_bearing = -0.7,
                           .bearing_step = 0.0123,
                           .robot_from_laser = {0.25, -0.1, 0.5}});
  std::get<LaserScan>(log.measurements[1]).remissions.assign(97, 12.5);
  log.parameters["robot_width"] = "0.4";
  const RecordedLog read = parse_log("a.log", carmen_text(log));
  expect_equal(read, log);
  EXPECT_EQ(read.parameters, log.parameters);
  EXPECT_EQ(odometry_at(read, 4).forward_velocity, odometry_at(log, 4).forward_velocity);
  EXPECT_EQ(carmen_text(read), carmen_text(log));
}

TEST(CarmenLog, TheOldDialectReadsBackTheSame) {
  const RecordedLog log = drive({.beams = 98,
                                 .first_bearing = -0.7,
                                 .bearing_step = 0.0123,
                                 .robot_from_laser = {0.25, -0.1, 0.5}});
  const std::string path = ::testing::TempDir() + "old_dialect.log.gz";
  write_carmen_log(path, log, CarmenDialect::flaser);
  EXPECT_THAT(read_text_file(path), HasSubstr("\nFLASER 98 "));
  expect_equal(load_log(path), log);
}

TEST(CarmenLog, ALogWithoutOdometryStaysWithout) {
  RecordedLog log = drive({.robot_from_laser = {0.25, 0, kPi}});
  std::erase_if(log.measurements,
                [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
  expect_equal(parse_log("a.log", carmen_text(log)), log);
}

// Front laser level, and behind each of its scans one of each other laser at `mounts`.
RecordedLog drive_with(const std::vector<Mount>& mounts, double beam_period) {
  RecordedLog log = drive();
  SensorLog all;
  for (const Measurement& m : log.measurements) {
    all.push_back(m);
    const auto* scan = std::get_if<LaserScan>(&m);
    for (std::size_t i = 0; scan != nullptr && i < mounts.size(); ++i) {
      LaserScan other = *scan;
      other.laser = static_cast<int>(i) + 1;
      other.robot_from_laser = mounts[i];
      other.beam_period = beam_period;
      other.time += 0.01 * other.laser;
      all.emplace_back(Odometry{other.time, {0.5, 0.25, 0.125}});
      all.emplace_back(std::move(other));
    }
  }
  log.measurements = std::move(all);
  return log;
}

TEST(CarmenLog, ATiltedSecondLaserAndBeamTimesReadBackTheSame) {
  const RecordedLog log = drive_with({Mount{{0.25, 0, 0}, 1.1, radians(10), -0.02}}, -1.0 / 3e4);
  const std::string text = carmen_text(log);
  expect_equal(parse_log("a.log", text), log);
  EXPECT_THAT(text, HasSubstr("\nLASERMOUNT 2 1.1 "));
  EXPECT_EQ(text.find("LASERMOUNT"), text.rfind("LASERMOUNT"));  // once
}

TEST(CarmenLog, LasersThatScanAtOneMomentShareTheirOdometry) {
  RecordedLog log = drive();
  for (std::size_t i = 1; i < log.measurements.size(); i += 3) {  // odometry, scan, scan, …
    LaserScan rear = scan_at(log, i);
    rear.laser = 1;
    log.measurements.insert(log.measurements.begin() + static_cast<std::ptrdiff_t>(i) + 1, rear);
  }
  expect_equal(parse_log("a.log", carmen_text(log)), log);
}

TEST(CarmenLog, AsManyLasersAsThereAreReadBackTheSame) {
  std::vector<Mount> mounts;
  for (int i = 0; i < 11; ++i) mounts.push_back({{0.1 * i, 0.05, 0.2}, 0.3 * i, 0.0, 0.0});
  const RecordedLog log = drive_with(mounts, 0.0);
  EXPECT_THAT(carmen_text(log), HasSubstr("\nROBOTLASER12 "));
  expect_equal(parse_log("a.log", carmen_text(log)), log);

  RecordedLog scans_only = log;
  std::erase_if(scans_only.measurements,
                [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
  expect_equal(parse_log("a.log", carmen_text(scans_only)), scans_only);
}

TEST(CarmenLog, AMountThatChangesIsSaidAgain) {
  RecordedLog log = drive();
  std::get<LaserScan>(log.measurements[3]).robot_from_laser.pitch = 0.1;
  std::get<LaserScan>(log.measurements[5]).beam_period = 1e-5;
  expect_equal(parse_log("a.log", carmen_text(log)), log);
}

TEST(CarmenLog, NoMountLinesStandWhereNothingNeedsThem) {
  EXPECT_EQ(carmen_text(drive()).find("LASERMOUNT"), std::string::npos);
}

TEST(CarmenLog, AMountHoldsForTheScansThatFollowOfItsLaser) {
  const RecordedLog log = parse_log(
      "a.log", kRobotLaser + "LASERMOUNT 1 0.4 0.1 -0.2 1e-05 100 host 0\n" + kRobotLaser);
  EXPECT_EQ(scan_at(log, 1).robot_from_laser.z, 0.0);
  EXPECT_EQ(scan_at(log, 3).robot_from_laser.z, 0.4);
  EXPECT_EQ(scan_at(log, 3).robot_from_laser.pitch, 0.1);
  EXPECT_EQ(scan_at(log, 3).robot_from_laser.roll, -0.2);
  EXPECT_EQ(scan_at(log, 3).beam_period, 1e-5);
  EXPECT_EQ(scan_at(log, 3).robot_from_laser.planar, scan_at(log, 1).robot_from_laser.planar);
}

TEST(CarmenLog, ABrokenMountLineIsLeftOutWithItsLine) {
  for (const char* line : {"LASERMOUNT 1 0.4 0.1", "LASERMOUNT 1 0.4 x -0.2 0 100 host 0"}) {
    const RecordedLog log = parse_log("a.log", kRobotLaser + line + "\n" + kRobotLaser);
    EXPECT_THAT(to_string(log.warnings.at(0)),
                ::testing::StartsWith("a.log:2: truncated or garbled LASERMOUNT line: left out"));
    EXPECT_EQ(scan_at(log, 3).robot_from_laser.z, 0.0);
  }
  for (const char* line :
       {"LASERMOUNT 0 0.4 0 0 0 100 host 0", "LASERMOUNT 1.5 0.4 0 0 0 100 host 0",
        "LASERMOUNT 1 0.4 nan 0 0 100 host 0", "LASERMOUNT 1 0.4 10 0 0 100 host 0"}) {
    const RecordedLog log = parse_log("a.log", kRobotLaser + line + "\n" + kRobotLaser);
    EXPECT_EQ(to_string(log.warnings.at(0)),
              "a.log:2: LASERMOUNT line without a sensible mount: left out");
    EXPECT_EQ(scan_at(log, 3).robot_from_laser.z, 0.0);
  }
}

TEST(CarmenLog, TheOldDialectIsRefusedForGeometryThatItCannotSay) {
  RecordedLog log = drive();
  std::get<LaserScan>(log.measurements[3]).bearing_step = 0.01;
  try {
    old_carmen_text(log);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "FLASER lines cannot say the geometry of the scan at 1000.250000; write "
                 "ROBOTLASER lines");
  }
}

constexpr const char* kRfid =
    "RFIDMOUNT 2 0.1 0.2 0.75 1.1 -0.1 0.05 100 host 0\n"
    "RFID 2 915000000 2 tag_7 -61.5 0.25 E2801160 nan nan 100.5 host 0\n"
    "RFID 2 915000000 0 101 host 0\n";

TEST(CarmenLog, AnRfidLineIsAnInventoryRoundWithTheMountSaidBefore) {
  const RecordedLog log = parse_log("a.log", kRfid);
  ASSERT_EQ(log.measurements.size(), 2u);
  const auto& round = std::get<RfidDetections>(log.measurements[0]);
  EXPECT_EQ(round.antenna, 1);
  EXPECT_EQ(round.time, 100.5);
  EXPECT_EQ(round.frequency, 915e6);
  EXPECT_EQ(round.robot_from_antenna, (Mount{{0.1, 0.2, 0.75}, 1.1, -0.1, 0.05}));
  ASSERT_EQ(round.reads.size(), 2u);
  EXPECT_EQ(round.reads[0].tag, "tag_7");
  EXPECT_EQ(round.reads[0].rssi, -61.5);
  EXPECT_EQ(round.reads[0].phase, 0.25);
  EXPECT_EQ(round.reads[1].tag, "E2801160");
  EXPECT_FALSE(round.reads[1].has_rssi() || round.reads[1].has_phase());
  EXPECT_TRUE(std::get<RfidDetections>(log.measurements[1]).reads.empty());
}

TEST(CarmenLog, RfidRoundsAreWrittenAsTheyAreRead) {
  const RecordedLog log = parse_log("a.log", kRobotLaser + kRfid);
  const std::string text = carmen_text(log);
  EXPECT_EQ(carmen_text(parse_log("b.log", text)), text);
  EXPECT_THAT(text, HasSubstr("\nRFID 2 915000000 2 tag_7 -61.5 0.25 E2801160 nan nan 100.5 "));
  EXPECT_EQ(text.find("RFIDMOUNT"), text.rfind("RFIDMOUNT"));  // once
}

TEST(CarmenLog, RfidLinesThatAreNotWholeAreLeftOut) {
  for (const char* line :
       {"RFID 2 915e6 2 tag_7 -61.5 0.25 100.5 host 0", "RFID 2 915e6 1 tag_7 loud 0 100 host 0",
        "RFID 3 915e6 0 100.5 host 0", "RFIDMOUNT 0 0 0 0 0 0 0 100 host 0",
        "RFIDMOUNT 1 nan 0 0 0 0 0 100 host 0"}) {
    const RecordedLog log = parse_log("a.log", kRobotLaser + kRfid + line + std::string("\n"));
    EXPECT_EQ(log.measurements.size(), 4u) << line;
    ASSERT_EQ(log.warnings.size(), 1u) << line;
    EXPECT_THAT(to_string(log.warnings[0]), HasSubstr("left out")) << line;
  }
}

TEST(CarmenLog, ATagWithoutANameOfOneWordIsNotWritten) {
  RecordedLog log = parse_log("a.log", kRfid);
  std::get<RfidDetections>(log.measurements[0]).reads[0].tag = "tag 7";
  EXPECT_THROW(carmen_text(log), InputError);
}

}  // namespace
}  // namespace mapbed
