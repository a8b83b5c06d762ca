// Bags that programs of others have written, all of one recording: python3-rosbag (.bag),
// @mcap/core with @foxglove/rosmsg2-serialization (.mcap), and the same messages in the tables of
// ROS 2 by Python's sqlite3 (.db3).

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/log/dialects/carmen_log.h"
#include "core/log/log_file.h"
#include "core/testing/is_near.h"
#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

std::string bag(const std::string& name) {
  return source_tree() + "/core/log/bags/testdata/foreign/" + name;
}

constexpr double kStart = 1600000000.0;  // [s]

class ForeignBag : public ::testing::TestWithParam<const char*> {};

TEST_P(ForeignBag, HasTheScansOnTheRobotAndTheOdometryOfTheRecording) {
  const RecordedLog log = load_log(bag(GetParam()));
  EXPECT_THAT(log.warnings, ::testing::IsEmpty());
  ASSERT_EQ(log.measurements.size(), 6u);
  for (int k = 0; k < 3; ++k) {
    const auto& odometry = std::get<Odometry>(log.measurements[static_cast<std::size_t>(2 * k)]);
    EXPECT_EQ(odometry.time, kStart + 0.25 * k + 0.125);
    EXPECT_EQ(odometry.odometry_from_robot, (Pose2{0.5 * k, -0.25 * k, 0.0}));
    EXPECT_EQ(odometry.forward_velocity, 2.0);
    EXPECT_EQ(odometry.turn_velocity, -0.5);
    const auto& scan = std::get<LaserScan>(log.measurements[static_cast<std::size_t>(2 * k + 1)]);
    EXPECT_EQ(scan.time, kStart + 0.25 * k + 0.1875);
    EXPECT_EQ(scan.first_bearing, -1.0);
    EXPECT_EQ(scan.bearing_step, 0.5);
    EXPECT_EQ(scan.beam_period, 0.0009765625);
    EXPECT_EQ(scan.max_range, 8.0);
    // A hit, nothing hit, no number, nearer than range_min, beyond range_max.
    EXPECT_THAT(scan.ranges, ElementsAre(1.5 + k, 8.0, 0.0, 0.0, 9.0));
    const std::vector<double> intensities{10, 20, 30, 40, 50};
    EXPECT_EQ(scan.remissions, k == 1 ? std::vector<double>{} : intensities);
    // Half the turn has sine 0.6 and cosine 0.8.
    EXPECT_THAT(scan.robot_from_laser.planar,
                IsNear(Pose2{0.25, -0.125, 2.0 * std::atan2(0.6, 0.8)}, Tolerance{1e-9, 1e-9}));
    EXPECT_EQ(scan.robot_from_laser.z, 0.5);
    EXPECT_TRUE(scan.robot_from_laser.is_level());
  }
}

TEST_P(ForeignBag, GivesTheSameBytesAsAllOthers) {
  EXPECT_EQ(carmen_text(load_log(bag(GetParam()))), carmen_text(load_log(bag("none.bag"))));
}

TEST_P(ForeignBag, TellsItsTopics) {
  const auto contents = bag_contents(bag(GetParam()));
  ASSERT_TRUE(contents);
  std::string topics;
  for (const RecordedTopic& topic : contents->topics)
    topics +=
        topic.name + " " + topic.type + " " + std::to_string(topic.messages) + topic.unread + "\n";
  EXPECT_EQ(
      topics,
      "/chatter std_msgs/String 1no measurement here is of this kind\n/odom nav_msgs/Odometry 3\n"
      "/scan sensor_msgs/LaserScan 3\n/tf_static tf2_msgs/TFMessage 1\n");
  EXPECT_NEAR(contents->seconds, 0.6875, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Written, ForeignBag,
                         ::testing::Values("none.bag", "bz2.bag", "lz4.bag", "none.mcap",
                                           "unchunked.mcap", "lz4.mcap", "zstd.mcap", "humble.db3",
                                           "iron.db3", "packed.db3", "humble.db3.zstd"));

}  // namespace
}  // namespace mapbed
