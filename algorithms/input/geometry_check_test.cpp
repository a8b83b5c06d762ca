#include "algorithms/input/geometry_check.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<Eigen::Vector2d> way() {
  return {{-3, 0}, {3, 0}, {3, 2}, {-2, 2}, {-2, -2}, {2, -2.5}, {2, 1}};
}

RecordedLog drive_with(const TestLaser& laser, const TestRoom& room = furnished_room(),
                       std::uint64_t seed = 3) {
  return drive_through(room, way(), {.laser = laser, .scan_period = 0.2}, Rng(seed));
}

// The same ranges, read with a geometry that is not the laser's.
RecordedLog read_as(RecordedLog log, const Bearings& bearings, std::vector<Bearings> candidates) {
  std::size_t beams = 0;
  for (Measurement& m : log.measurements) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) continue;
    scan->first_bearing = bearings.first;
    scan->bearing_step = bearings.step;
    beams = scan->ranges.size();
  }
  log.lasers = {{0, beams, bearings, {}, "a guess", std::move(candidates)}};
  return log;
}

const Bearings kHalf{-kPi / 2, radians(0.5)};
const Bearings kFromBehind{-kPi, radians(1.0)};
const Bearings kFromTheFront{0.0, radians(1.0)};

Bearings found_in(const TestLaser& laser) {
  RecordedLog log = read_as(drive_with(laser), kHalf, {kFromBehind, kFromTheFront});
  EXPECT_THAT(choose_geometry(log), IsEmpty());
  EXPECT_THAT(remarks_on_geometry(log.measurements), IsEmpty());
  const auto& scan = std::get<LaserScan>(log.measurements.back());
  EXPECT_EQ((Bearings{scan.first_bearing, scan.bearing_step}), log.lasers[0].bearings);
  return log.lasers[0].bearings;
}

TEST(GeometryCheck, ScansTellAFullCircleFromAHalf) {
  EXPECT_EQ(found_in({360, -kPi, radians(1.0), 12.0, {}}), kFromBehind);
  EXPECT_EQ(found_in({360, 0.0, radians(1.0), 12.0, {}}), kFromTheFront);
  EXPECT_EQ(found_in({360, -kPi / 2, radians(0.5), 12.0, {}}), kHalf);
}

TEST(GeometryCheck, ScansTellACircleThatRunsClockwise) {
  EXPECT_EQ(found_in({360, kPi, radians(-1.0), 12.0, {}}), (Bearings{kPi, radians(-1.0)}));
}

TEST(GeometryCheck, AChoiceSaysWhereItComesFrom) {
  RecordedLog log =
      read_as(drive_with({360, -kPi, radians(1.0), 12.0, {}}), kHalf, {kFromBehind, kFromTheFront});
  choose_geometry(log);
  EXPECT_THAT(log.lasers[0].source, HasSubstr("chosen by comparing scans: "));
  EXPECT_THAT(log.lasers[0].source, HasSubstr("with 0.5 deg from -90 deg of a guess"));
}

TEST(GeometryCheck, ARobotThatStandsLeavesItAmbiguousAndIsToldSo) {
  RecordedLog log =
      read_as(drive_with({360, -kPi, radians(1.0), 12.0, {}}), kHalf, {kFromBehind, kFromTheFront});
  for (Measurement& m : log.measurements)
    if (auto* odometry = std::get_if<Odometry>(&m)) odometry->odometry_from_robot = {};
  const std::vector<Remark> remarks = choose_geometry(log);
  EXPECT_EQ(log.lasers[0].bearings, kHalf);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].kind, RemarkKind::note);
  EXPECT_THAT(remarks[0].text, HasSubstr("360 beams point is ambiguous"));
}

struct Contradiction {
  TestLaser laser;
  Bearings stated;
  RemarkKind kind;
  const char* what;
};

class IsTold : public ::testing::TestWithParam<Contradiction> {};

TEST_P(IsTold, WhatScansContradict) {
  const auto& [laser, stated, kind, what] = GetParam();
  const RecordedLog log = read_as(drive_with(laser), stated, {});
  const std::vector<Remark> remarks = remarks_on_geometry(log.measurements);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].kind, kind);
  EXPECT_THAT(remarks[0].text, HasSubstr(what));
}

INSTANTIATE_TEST_SUITE_P(
    GeometryCheck, IsTold,
    ::testing::Values(
        Contradiction{{}, {kPi / 2, radians(-1)}, RemarkKind::laser_mount, "upside down"},
        Contradiction{{}, {kPi / 2, radians(1)}, RemarkKind::laser_mount, "looks backwards"},
        Contradiction{{.first_bearing = kPi / 2},
                      {-kPi / 2, radians(1)},
                      RemarkKind::laser_mount,
                      "looks backwards"},
        Contradiction{{271, radians(-135), radians(1), 8.0, {}},
                      {radians(135), radians(-1)},
                      RemarkKind::laser_mount,
                      "upside down"},
        Contradiction{{}, {-kPi, radians(2)}, RemarkKind::beam_geometry, "half as far apart"},
        Contradiction{
            {}, {-kPi / 4, radians(0.5)}, RemarkKind::beam_geometry, "twice as far apart"}));

TEST(GeometryCheck, WhatIsRightGivesNoRemark) {
  const TestLaser lasers[] = {{},
                              {361, -kPi / 2, radians(0.5), 30.0, {}},
                              {271, radians(-135), radians(1), 4.0, {}},
                              {360, -kPi, radians(1), 12.0, {0.1, 0.0, 0.3}},
                              {19, -kPi / 2, radians(10), 8.0, {}}};
  for (const TestLaser& laser : lasers) {
    for (const TestRoom& room : {furnished_room(), corridor(20.0), rectangular_room(9.0, 9.0)}) {
      EXPECT_THAT(remarks_on_geometry(drive_with(laser, room).measurements), IsEmpty())
          << laser.beams;
    }
  }
}

TEST(GeometryCheck, OdometryThatIsBadMakesNothingClear) {
  RecordedLog log = read_as(drive_with({}), {-kPi / 2, radians(1)}, {});
  double turned = 0.0;
  for (Measurement& m : log.measurements) {
    auto* odometry = std::get_if<Odometry>(&m);
    if (odometry != nullptr) odometry->odometry_from_robot.theta += (turned += 0.1);
  }
  EXPECT_THAT(remarks_on_geometry(log.measurements), IsEmpty());
}

}  // namespace
}  // namespace mapbed
