#include "core/log/ros/ros_scan.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/log/laser_geometry.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

RosLaserScan message() {
  RosLaserScan message;
  message.angle_min = -1.0;
  message.angle_max = 1.0;
  message.angle_increment = 0.5;
  message.range_min = 0.125;
  message.range_max = 8.0;
  message.ranges = {1.0, 2.0, 3.0, 4.0, 5.0};
  return message;
}

TEST(RosScan, RangesMeanWhatRep117Says) {
  RosLaserScan odd = message();
  odd.ranges = {INFINITY, -INFINITY, NAN, 0.0625, 0.125, 0.0};
  EXPECT_THAT(converted(std::move(odd)).scan.ranges,
              ElementsAre(INFINITY, kNoReading, kNoReading, kNoReading, 0.125, 0.0));
}

TEST(RosScan, AMaximumThatNoLaserHasIsNotTold) {
  for (const double most : {0.0, -1.0, double{INFINITY}, double{NAN}, 1e6}) {
    RosLaserScan odd = message();
    odd.range_max = most;
    EXPECT_EQ(converted(std::move(odd)).scan.max_range, 0.0) << most;
  }
}

TEST(RosScan, TimeBetweenBeamsCountsWhereItFitsTheTimeBetweenScans) {
  RosLaserScan good = message();
  good.time_increment = 0.001;
  good.scan_time = 0.1;
  EXPECT_EQ(converted(std::move(good)).scan.beam_period, 0.001);
  RosLaserScan bad = message();
  bad.time_increment = 0.1;  // as some drivers do: that of a whole scan
  bad.scan_time = 0.1;
  const ConvertedScan scan = converted(std::move(bad));
  EXPECT_EQ(scan.scan.beam_period, 0.0);
  EXPECT_THAT(scan.remark, HasSubstr("time_increment does not fit scan_time"));
}

TEST(RosScan, IntensitiesCountWhereEachBeamHasOne) {
  RosLaserScan some = message();
  some.intensities = {1, 2};
  EXPECT_TRUE(converted(std::move(some)).scan.remissions.empty());
}

TEST(RosScan, AHitIsInTheSamePlaceWhetherTheLaserHangsOrStands) {
  // By the pose in space, without the upright mount that it becomes.
  const Pose3 mount{{0.5, -0.25, 1.0}, rotation_of(0.75, 0.0, kPi)};
  LaserScan scan = converted(message()).scan;
  const double bearing = scan.bearing(3);
  const Eigen::Vector3d hit =
      mount * Eigen::Vector3d(4.0 * std::cos(bearing), 4.0 * std::sin(bearing), 0.0);
  set_mount(scan, mount);
  EXPECT_NEAR((scan.point_on(3, 4.0) - hit.head<2>()).norm(), 0.0, 1e-8);
  EXPECT_TRUE(scan.robot_from_laser.is_level());
  EXPECT_EQ(scan.robot_from_laser.z, 1.0);
}

TEST(RosScan, ATiltedMountKeepsItsAngles) {
  LaserScan scan = converted(message()).scan;
  set_mount(scan, {{0.0, 0.0, 0.0}, rotation_of(0.5, 0.25, -0.125)});
  EXPECT_NEAR(scan.robot_from_laser.planar.theta, 0.5, 1e-9);
  EXPECT_NEAR(scan.robot_from_laser.pitch, 0.25, 1e-9);
  EXPECT_NEAR(scan.robot_from_laser.roll, -0.125, 1e-9);
}

}  // namespace
}  // namespace mapbed
