#include "algorithms/submaps/scan_view.h"

#include <gtest/gtest.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr double kMargin = 0.3;

// A room of 6 m x 4 m, seen from its middle.
ScanView view_of(const TestLaser& laser) {
  return {scan_of(rectangular_room(6.0, 4.0), {}, laser), 30.0, 20.0};
}

TEST(ScanView, TellsFreeGroundSurfacesAndWhatIsBehindThem) {
  const ScanView view = view_of({});
  EXPECT_EQ(view.at({2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(view.at({2.9, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(view.at({3.2, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(view.at({3.5, 0.0}, kMargin), Seen::nothing);
  EXPECT_EQ(view.at({0.5, 1.9}, kMargin), Seen::surface);
  EXPECT_EQ(view.at({0.5, -1.0}, kMargin), Seen::free);
}

TEST(ScanView, SaysNothingOfWhatIsBehindTheLaser) {
  const ScanView view = view_of({});
  EXPECT_EQ(view.at({-1.0, 0.0}, kMargin), Seen::nothing);
  EXPECT_EQ(view.at({-1.0, 0.5}, kMargin), Seen::nothing);
}

TEST(ScanView, IsTheSameForBeamsThatTurnTheOtherWay) {
  const ScanView view = view_of({.first_bearing = kPi / 2, .bearing_step = radians(-1.0)});
  EXPECT_EQ(view.at({2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(view.at({0.5, 1.9}, kMargin), Seen::surface);
  EXPECT_EQ(view.at({0.5, -2.5}, kMargin), Seen::nothing);
  EXPECT_EQ(view.at({-1.0, 0.2}, kMargin), Seen::nothing);
}

TEST(ScanView, CountsFromWhereTheLaserIsMounted) {
  // It looks back.
  const ScanView view = view_of({.robot_from_laser = {-0.5, 0.0, kPi}});
  EXPECT_EQ(view.at({-2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(view.at({-3.0, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(view.at({1.0, 0.0}, kMargin), Seen::nothing);
}

TEST(ScanView, AMissingReturnIsFreeGroundForShortLasersAlone) {
  const TestRoom hall = rectangular_room(60.0, 60.0);
  const LaserScan of_short = scan_of(hall, {}, {.max_range = 8.0});
  const ScanView near{of_short, 30.0, 20.0};
  EXPECT_EQ(near.at({7.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(near.at({8.1, 0.0}, kMargin), Seen::nothing);  // no surface is there
  const ScanView far{scan_of(hall, {}, {.max_range = 25.0}), 30.0, 20.0};
  EXPECT_EQ(far.at({7.0, 0.0}, kMargin), Seen::nothing);
}

TEST(ScanView, AnEdgeIsNeitherFreeNorHiddenBetweenTwoBeams) {
  TestRoom room = rectangular_room(20.0, 20.0);
  room.add({{3.0, 0.0}, {3.0, 5.0}});  // hides what is to the left behind it
  const ScanView view{scan_of(room, {}), 30.0, 20.0};
  EXPECT_EQ(view.at({5.0, 1.0}, kMargin), Seen::nothing);
  EXPECT_EQ(view.at({5.0, -1.0}, kMargin), Seen::free);
  EXPECT_EQ(view.at({3.1, 0.5}, kMargin), Seen::surface);
}

// As of a sweep that was corrected for the motion of the robot.
TEST(ScanView, TakesBeamsThatStartWhereEachIsTold) {
  LaserScan scan = scan_of(rectangular_room(6.0, 4.0), {});
  for (std::size_t n = 0; n < scan.ranges.size(); ++n) {
    scan.robot_from_beams.push_back({0.0, 0.0, scan.bearing(n)});
  }
  const ScanView view{scan, 30.0, 20.0};
  EXPECT_EQ(view.at({2.0, 0.0}, kMargin), Seen::free);
  EXPECT_EQ(view.at({3.2, 0.0}, kMargin), Seen::surface);
  EXPECT_EQ(view.at({-1.0, 0.0}, kMargin), Seen::nothing);
}

}  // namespace
}  // namespace mapbed
