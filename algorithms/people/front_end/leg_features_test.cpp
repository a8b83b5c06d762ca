#include "algorithms/people/front_end/leg_features.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/people/testing/people_in_a_room.h"

namespace mapbed {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kRadius = 0.07;  // [m] of a leg

TestLaser laser_of(double step_in_degrees, double view_in_degrees) {
  return {.beams = static_cast<int>(view_in_degrees / step_in_degrees) + 1,
          .first_bearing = -radians(view_in_degrees / 2.0),
          .bearing_step = radians(step_in_degrees),
          .max_range = 20.0};
}

std::vector<LegFeature> features_in(const TestRoom& room, const TestLaser& laser) {
  return leg_features(ScanView(scan_of(room, {}, laser)), {});
}

struct LaserAndRange {
  double step;   // [deg]
  double view;   // [deg]
  double range;  // [m]
};

class FindsALeg : public ::testing::TestWithParam<LaserAndRange> {};

TEST_P(FindsALeg, WhereItIs) {
  const auto [step, view, range] = GetParam();
  TestRoom room = rectangular_room(24.0, 20.0);
  const Eigen::Vector2d axis = range * Eigen::Vector2d(std::cos(0.3), std::sin(0.3));
  add_leg(room, axis);
  const std::vector<LegFeature> features = features_in(room, laser_of(step, view));
  ASSERT_THAT(features, SizeIs(1));
  // Across it is known to half the spacing of beams, along to the leg's roundness.
  const double across = 0.5 * range * radians(step) + 0.03;
  EXPECT_LT((features[0].position - axis).norm(), across);
  EXPECT_NEAR(features[0].range, range, 0.04);
  EXPECT_LE(features[0].width, 2.0 * kRadius + 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    LegFeatures, FindsALeg,
    ::testing::Values(LaserAndRange{0.25, 270, 1.0}, LaserAndRange{0.25, 270, 8.0},
                      LaserAndRange{0.5, 180, 3.0}, LaserAndRange{1.0, 180, 2.0},
                      LaserAndRange{1.0, 180, 8.0}, LaserAndRange{1.0, 359, 5.0}));

TEST(LegFeatures, FindsBothLegsAndTheirBeams) {
  TestRoom room = rectangular_room(10.0, 8.0);
  add_leg(room, {2.0, -0.15});
  add_leg(room, {2.0, 0.15});
  const std::vector<LegFeature> features = features_in(room, laser_of(0.5, 180));
  ASSERT_THAT(features, SizeIs(2));
  // atan(0.07 / 2) to each side of the axis: 4.0 deg of half a degree each.
  EXPECT_NEAR(static_cast<double>(features[0].last - features[0].first + 1), 8.0, 1.0);
}

TEST(LegFeatures, OfAnEmptyRoomAreNone) {
  EXPECT_THAT(features_in(rectangular_room(10.0, 6.0), laser_of(0.5, 270)), IsEmpty());
}

TEST(LegFeatures, TakesNoWallSeenAslantForLegs) {
  // Ranges along it jump by more than a leg stands in front of anything.
  TestRoom room({{{0.5, 0.4}, {19.0, 0.4}}, {{0.5, -0.4}, {19.0, -0.4}}});
  EXPECT_THAT(features_in(room, laser_of(1.0, 180)), IsEmpty());
}

TEST(LegFeatures, TakesNoBoxOfHalfAMetreForALeg) {
  TestRoom room = rectangular_room(10.0, 6.0);
  room.add_box({2.0, 0.0}, 0.6, 0.6);
  EXPECT_THAT(features_in(room, laser_of(0.5, 180)), IsEmpty());
}

TEST(LegFeatures, ALegBesideSomethingNearerLooksLessLikeOne) {
  TestRoom room = rectangular_room(10.0, 6.0);
  add_leg(room, {3.0, 0.0});
  const LaserScan open = scan_of(room, {}, laser_of(0.5, 180));
  room.add({{1.0, -1.0}, {1.0, -0.01}});
  const LaserScan hidden = scan_of(room, {}, laser_of(0.5, 180));
  const std::vector<LegFeature> whole = leg_features(ScanView(open), {});
  const std::vector<LegFeature> half = leg_features(ScanView(hidden), {});
  ASSERT_THAT(whole, SizeIs(1));
  ASSERT_THAT(half, SizeIs(1));
  EXPECT_LT(half[0].quality, whole[0].quality);
  EXPECT_LT(half[0].width, whole[0].width);
}

TEST(LegFeatures, FailedBeamsAboutALegSayNothing) {
  TestRoom room = rectangular_room(10.0, 6.0);
  add_leg(room, {3.0, 0.0});
  LaserScan scan = scan_of(room, {}, laser_of(0.5, 180));
  for (double& range : scan.ranges) {
    if (range > 3.5) range = 0.0;
  }
  EXPECT_THAT(leg_features(ScanView(scan), {}), SizeIs(1));
}

TEST(LegFeatures, OfTwoLasersInOneScanAreInTheRobotsFrame) {
  TestRoom room = rectangular_room(10.0, 6.0);
  add_leg(room, {2.0, 0.3});
  add_leg(room, {-2.0, 0.3});
  LaserScan fused;
  fused.max_range = 20.0;
  for (const Pose2& mount : {Pose2{0.3, 0.0, 0.0}, Pose2{-0.3, 0.0, kPi}}) {
    TestLaser laser = laser_of(0.5, 180);
    laser.robot_from_laser = mount;
    const LaserScan scan = scan_of(room, {}, laser);
    fused.parts.push_back({0.0, static_cast<int>(fused.parts.size()), scan.ranges.size()});
    for (std::size_t b = 0; b < scan.ranges.size(); ++b) {
      fused.ranges.push_back(scan.ranges[b]);
      fused.robot_from_beams.push_back(mount * Pose2{0.0, 0.0, scan.bearing(b)});
    }
  }
  const std::vector<LegFeature> features = leg_features(ScanView(fused), {});
  ASSERT_THAT(features, SizeIs(2));
  EXPECT_LT((features[0].position - Eigen::Vector2d(2.0, 0.3)).norm(), 0.05);
  EXPECT_LT((features[1].position - Eigen::Vector2d(-2.0, 0.3)).norm(), 0.05);
  EXPECT_GE(features[1].first, 361U);
}

TEST(LegFeatures, AreTheSameOfBeamsThatAreCountedClockwise) {
  TestRoom room = rectangular_room(10.0, 6.0);
  add_leg(room, {3.0, 1.0});
  const TestLaser laser = laser_of(0.5, 180);
  TestLaser reversed = laser;
  reversed.first_bearing = -laser.first_bearing;
  reversed.bearing_step = -laser.bearing_step;
  const std::vector<LegFeature> a = features_in(room, laser);
  const std::vector<LegFeature> b = features_in(room, reversed);
  ASSERT_THAT(a, SizeIs(1));
  ASSERT_THAT(b, SizeIs(1));
  EXPECT_LT((a[0].position - b[0].position).norm(), 1e-9);
  EXPECT_EQ(b[0].first, 360U - a[0].last);
}

}  // namespace
}  // namespace mapbed
