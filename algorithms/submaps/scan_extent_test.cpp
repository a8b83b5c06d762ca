#include "algorithms/submaps/scan_extent.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr double kMargin = 0.3;

// A room of 6 m x 4 m, seen from its middle.
ScanExtent extent_of(const TestLaser& laser) {
  return {scan_of(rectangular_room(6.0, 4.0), {}, laser), 30.0, 20.0};
}

TEST(ScanExtent, TellsFreeGroundSurfacesAndWhatIsBehindThem) {
  const ScanExtent extent = extent_of({});
  EXPECT_EQ(extent.at({2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(extent.at({2.9, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(extent.at({3.2, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(extent.at({3.5, 0.0}, kMargin), Seen::nothing);
  EXPECT_EQ(extent.at({0.5, 1.9}, kMargin), Seen::surface);
  EXPECT_EQ(extent.at({0.5, -1.0}, kMargin), Seen::free);
}

TEST(ScanExtent, SaysNothingOfWhatIsBehindTheLaser) {
  const ScanExtent extent = extent_of({});
  EXPECT_EQ(extent.at({-1.0, 0.0}, kMargin), Seen::nothing);
  EXPECT_EQ(extent.at({-1.0, 0.5}, kMargin), Seen::nothing);
}

TEST(ScanExtent, IsTheSameForBeamsThatTurnTheOtherWay) {
  const ScanExtent extent = extent_of({.first_bearing = kPi / 2, .bearing_step = radians(-1.0)});
  EXPECT_EQ(extent.at({2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(extent.at({0.5, 1.9}, kMargin), Seen::surface);
  EXPECT_EQ(extent.at({0.5, -2.5}, kMargin), Seen::nothing);
  EXPECT_EQ(extent.at({-1.0, 0.2}, kMargin), Seen::nothing);
}

TEST(ScanExtent, CountsFromWhereTheLaserIsMounted) {
  // It looks back.
  const ScanExtent extent = extent_of({.robot_from_laser = {-0.5, 0.0, kPi}});
  EXPECT_EQ(extent.at({-2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(extent.at({-3.0, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(extent.at({1.0, 0.0}, kMargin), Seen::nothing);
}

TEST(ScanExtent, AMissingReturnIsFreeGroundForShortLasersAlone) {
  const TestRoom hall = rectangular_room(60.0, 60.0);
  const LaserScan of_short = scan_of(hall, {}, {.max_range = 8.0});
  const ScanExtent near{of_short, 30.0, 20.0};
  EXPECT_EQ(near.at({7.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(near.at({8.1, 0.0}, kMargin), Seen::nothing);  // no surface is there
  const ScanExtent far{scan_of(hall, {}, {.max_range = 25.0}), 30.0, 20.0};
  EXPECT_EQ(far.at({7.0, 0.0}, kMargin), Seen::nothing);
}

TEST(ScanExtent, AnEdgeIsNeitherFreeNorHiddenBetweenTwoBeams) {
  TestRoom room = rectangular_room(20.0, 20.0);
  room.add({{3.0, 0.0}, {3.0, 5.0}});  // hides what is to the left behind it
  const ScanExtent extent{scan_of(room, {}), 30.0, 20.0};
  EXPECT_EQ(extent.at({5.0, 1.0}, kMargin), Seen::nothing);
  EXPECT_EQ(extent.at({5.0, -1.0}, kMargin), Seen::free);
  EXPECT_EQ(extent.at({3.1, 0.5}, kMargin), Seen::surface);
}

// Between its neighbours nothing is known, up to the last bits of a bearing, wherever it points.
TEST(ScanExtent, AMissingBeamLeavesAGapFromTheOneBeforeToTheOneAfter) {
  constexpr double kHair = 1e-9;  // [rad]
  for (const double turning : {1.0, -1.0}) {
    for (const double first : {-kPi, -2.0, 0.7}) {
      for (std::size_t missing = 2; missing < 358; missing += 7) {
        LaserScan scan;
        scan.first_bearing = first;
        scan.bearing_step = turning * radians(1.0);
        scan.max_range = 10.0;
        scan.ranges.assign(360, 5.0);
        scan.ranges[missing] = 0.0;
        const ScanExtent extent{scan, 30.0, 20.0};
        const auto seen = [&](double beam, double off) {
          const double bearing = first + turning * (radians(beam) + off);
          return extent.at({3.0 * std::cos(bearing), 3.0 * std::sin(bearing)}, kMargin);
        };
        const auto at = static_cast<double>(missing);
        EXPECT_EQ(seen(at - 1.0, -kHair), Seen::free) << missing;
        EXPECT_EQ(seen(at - 1.0, kHair), Seen::nothing) << missing;
        EXPECT_EQ(seen(at + 0.3, 0.0), Seen::nothing) << missing;
        EXPECT_EQ(seen(at + 1.0, -kHair), Seen::nothing) << missing;
        EXPECT_EQ(seen(at + 1.0, kHair), Seen::free) << missing;
      }
    }
  }
}

// As of a sweep that was corrected for the motion of the robot.
TEST(ScanExtent, TakesBeamsThatStartWhereEachIsTold) {
  LaserScan scan = scan_of(rectangular_room(6.0, 4.0), {});
  for (std::size_t n = 0; n < scan.ranges.size(); ++n) {
    scan.robot_from_beams.push_back({0.0, 0.0, scan.bearing(n)});
  }
  const ScanExtent extent{scan, 30.0, 20.0};
  EXPECT_EQ(extent.at({2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(extent.at({3.2, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(extent.at({-1.0, 0.0}, kMargin), Seen::nothing);
}

}  // namespace
}  // namespace mapbed
