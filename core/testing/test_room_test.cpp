#include "core/testing/test_room.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

TEST(TestRoom, ARayMeetsTheNearestWall) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  EXPECT_NEAR(room.distance_to_wall({1.0, 0.0}, 0.0), 2.0, 1e-12);
  EXPECT_NEAR(room.distance_to_wall({1.0, 0.0}, kPi), 4.0, 1e-12);
  EXPECT_NEAR(room.distance_to_wall({1.0, 0.5}, kPi / 2), 1.5, 1e-12);
  EXPECT_NEAR(room.distance_to_wall({1.0, 0.0}, kPi / 4), 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(TestRoom, ARayOutOfACorridorMeetsNothing) {
  EXPECT_EQ(corridor(10.0).distance_to_wall({0.0, 0.3}, 0.0), INFINITY);
}

TEST(TestRoom, ACornerHasNoGap) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  EXPECT_NEAR(room.distance_to_wall({0.0, 0.0}, std::atan2(2.0, 3.0)), std::sqrt(13.0), 1e-9);
}

TEST(ScanOf, SeesFromWhereTheLaserStands) {
  TestLaser laser;
  laser.robot_from_laser = {0.5, 0.0, kPi};  // looks back
  const LaserScan scan = scan_of(rectangular_room(6.0, 4.0), {1.0, 0.0, 0.0}, laser, 7.0);
  EXPECT_EQ(scan.time, 7.0);
  EXPECT_NEAR(scan.ranges[90], 4.5, 1e-12);
  EXPECT_NEAR(scan.ranges[0], 2.0, 1e-12);
}

TEST(ScanOf, ReadsTheMaximumRangeWhereNothingIsHit) {
  const LaserScan scan = scan_of(corridor(100.0), {});
  EXPECT_EQ(scan.ranges[90], 8.0);
  EXPECT_TRUE(scan.is_max_range(90));
  EXPECT_NEAR(scan.ranges[0], 1.0, 1e-12);
}

TEST(WithRangeNoise, HasTheSigmaThatWasAskedForAndLeavesMissesAlone) {
  LaserScan scan;
  scan.max_range = 8.0;
  scan.ranges.assign(10'000, 4.0);
  scan.ranges.push_back(8.0);
  Rng rng(3);
  const LaserScan noisy = with_range_noise(scan, 0.05, rng);
  Moments error;
  for (std::size_t i = 0; i < 10'000; ++i) error.add(noisy.ranges[i] - 4.0);
  EXPECT_NEAR(error.mean(), 0.0, 5 * 0.05 / 100.0);  // five standard errors
  EXPECT_NEAR(error.sigma(), 0.05, 5 * 0.05 / std::sqrt(2e4));
  EXPECT_EQ(noisy.ranges.back(), 8.0);
}

TEST(DriveThrough, WithoutNoiseOdometryIsTheTruthSeenFromItsStart) {
  DriveOptions options;
  options.forward_sigma = options.turn_sigma = options.drift_sigma = 0.0;
  const RecordedLog log =
      drive_through(rectangular_room(6, 4), {{-2, 0}, {1, 0}, {1, 1}}, options, Rng(1));
  const Pose2 last =
      std::get<Odometry>(log.measurements[log.measurements.size() - 2]).odometry_from_robot;
  EXPECT_THAT(last, IsNear(Pose2{3.0, 1.0, kPi / 2}, Tolerance{1e-9, 1e-9}));
  EXPECT_THAT(log.true_poses.back().pose,
              IsNear(Pose2{1.0, 1.0, kPi / 2}, Tolerance{1e-12, 1e-12}));
  EXPECT_EQ(log.measurements.size(), 2 * log.true_poses.size());
}

TEST(ExamplePlace, TheTourKeepsARobotsRadiusFromAllWalls) {
  const TestRoom place = example_place();
  const RecordedLog log = drive_through(place, example_tour(), {}, Rng(1));
  for (const Stamped<Pose2>& p : log.true_poses)
    for (int i = 0; i < 360; i += 5)
      ASSERT_GT(place.distance_to_wall(p.pose.position(), radians(i)), 0.3)
          << p.pose.x << " " << p.pose.y;
}

}  // namespace
}  // namespace mapbed
