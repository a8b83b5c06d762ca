#include "core/log/recorded_lasers.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

std::string flaser(int beams, double time) {
  std::string line = fmt::format("FLASER {}", beams);
  for (int i = 0; i < beams; ++i) line += " 3.25";
  return line + fmt::format(" 0 0 0 0 0 0 {} host 0\n", time);
}

std::string flaser_lines(const std::vector<int>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i)
    text += flaser(counts[i], 10.0 + static_cast<double>(i));
  return text;
}

std::vector<LaserScan> scans_of(const RecordedLog& log) {
  std::vector<LaserScan> scans;
  for (const Measurement& m : log.measurements)
    if (const auto* scan = std::get_if<LaserScan>(&m)) scans.push_back(*scan);
  return scans;
}

TEST(RecordedLasers, SayWhereTheyLookAndWhoSaysSo) {
  EXPECT_EQ(to_string(parse_log("a.log", flaser(360, 1)).lasers.at(0)),
            "front laser: 360 beams, 0.5 deg from -90 deg (the number of beams, 360), at (0 m, 0 "
            "m, 0 deg)");
  const std::string stated =
      "PARAM laser_front_laser_resolution 0.5\nPARAM "
      "robot_frontlaser_offset 0.25\n" +
      flaser(361, 1);
  EXPECT_EQ(to_string(parse_log("a.log", stated).lasers.at(0)),
            "front laser: 361 beams, 0.5 deg from -90 deg (PARAM), at (0.25 m, 0 m, 0 deg)");
  EXPECT_EQ(to_string(parse_log("a.log", stated, {.first_bearing = {0.0}}).lasers.at(0)),
            "front laser: 361 beams, 0.5 deg from 0 deg (option first_bearing, else PARAM), at "
            "(0.25 m, 0 m, 0 deg)");
  const std::string line =
      "ROBOTLASER2 0 -1.5 3 0.75 50 0.1 0 5 1 1 1 1 1 0 1 0 0 0 0 0 0 0 0 0 0 17 h 17\n";
  EXPECT_THAT(to_string(parse_log("a.log", line).lasers.at(0)),
              HasSubstr("rear laser: 5 beams, 42.972 deg from -85.944 deg (its lines)"));
}

TEST(RecordedLasers, AllScansOfAChangingNumberOfBeamsAreUsed) {
  for (const std::vector<int>& counts : {std::vector<int>{360, 360, 358, 359, 362, 361, 360},
                                         {181, 181, 178, 181},
                                         {1081, 1080, 1079, 1081}}) {
    const RecordedLog log = parse_log("a.log", flaser_lines(counts));
    EXPECT_EQ(scans_of(log).size(), counts.size());
    EXPECT_EQ(log.warnings.size(), 1u);  // told once
    for (const LaserScan& scan : scans_of(log))
      EXPECT_EQ(scan.bearing_step, log.lasers[0].bearings.step);
  }
}

TEST(RecordedLasers, ScansOfAFullCircleAreGivenTheirOwnPartsOfIt) {
  RecordedLog log = parse_log("a.log", flaser_lines({360, 358, 360, 361, 181}));
  set_bearings(log, log.lasers[0], {-kPi, radians(1)}, "somebody");
  const auto scans = scans_of(log);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scans[i].bearing_step * static_cast<double>(scans[i].ranges.size()), 2 * kPi,
                1e-12);
  EXPECT_EQ(scans[4].first_bearing, -kPi / 2);  // of another kind
  EXPECT_EQ(log.lasers[0].source, "somebody");
}

TEST(RecordedLasers, WhatIsOddAboutParametersIsToldWithTheirLine) {
  const RecordedLog log = parse_log("a.log",
                                    "PARAM laser_front_laser_resolution 0.5\n"
                                    "PARAM laser_front_laser_fov 3.14159\n" +
                                        flaser(361, 1));
  EXPECT_EQ(scans_of(log)[0].first_bearing, -0.5 * 3.14159 - 0.0);
  ASSERT_EQ(log.warnings.size(), 1u);
  EXPECT_EQ(to_string(log.warnings[0]),
            "a.log:2: laser_front_laser_fov: fov 3.14159 is taken as radians (180 deg)");
}

TEST(RecordedLasers, OfALineInDegreesTheBeamsAreTurnedIntoRadians) {
  std::string line = "ROBOTLASER1 0 -90 180 1 50 0.1 0 181";
  for (int i = 0; i < 181; ++i) line += " 3";
  const RecordedLog log = parse_log("a.log", line + " 0 0 0 0 0 0 0 0 0 0 0 0 17 h 17\n");
  EXPECT_NEAR(scans_of(log)[0].first_bearing, -kPi / 2, 1e-12);
  EXPECT_NEAR(scans_of(log)[0].bearing_step, radians(1), 1e-12);
  EXPECT_THAT(to_string(log.warnings.at(0)), HasSubstr("a.log:1: first bearing, field of view"));
}

TEST(RecordedLasers, StatementsThatContradictEachOtherLeaveAnotherCandidate) {
  std::string line = "ROBOTLASER1 0 -1.5707963 3.1415927 0.0174533 50 0.1 0 361";
  for (int i = 0; i < 361; ++i) line += " 3";
  const RecordedLog log = parse_log("a.log", line + " 0 0 0 0 0 0 0 0 0 0 0 0 17 h 17\n");
  ASSERT_EQ(log.lasers.at(0).candidates.size(), 1u);
  EXPECT_NEAR(degrees(log.lasers[0].candidates[0].step), 0.5, 1e-4);
  EXPECT_EQ(log.warnings.size(), 1u);
}

}  // namespace
}  // namespace mapbed
