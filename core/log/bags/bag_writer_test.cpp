// A log that is written as a bag is read back from it, whichever kind of bag that is.

#include "core/log/bags/bag_writer.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/config_node.h"
#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/log_formats.h"
#include "core/testing/example_log.h"
#include "core/testing/is_near.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

LaserScan scan_at(double time) {
  LaserScan scan;
  scan.time = time;
  scan.robot_from_laser = {Pose2{0.25, 0.0, 0.5}, 0.125, 0.0, 0.0};
  scan.first_bearing = -1.0;
  scan.bearing_step = 0.5;
  scan.beam_period = 0.001;
  scan.max_range = 8.0;
  scan.ranges = {1.1, 8.0, 0.0, 7.99999999, 2.5};  // the fourth is 8 as a float
  scan.remissions = {1.0, 2.0, 3.0, 4.0, 5.0};
  return scan;
}

RecordedLog short_log() {
  RecordedLog log;
  for (int k = 0; k < 4; ++k) {
    const double time = 1600000000.0 + 0.125 * k;
    log.measurements.emplace_back(Odometry{time, Pose2{0.1 * k, 0.0, 0.3 * k}, 1.0, 0.5});
    log.measurements.emplace_back(scan_at(time));
    log.true_poses.push_back({time, Pose2{0.1 * k, 0.01, 0.3 * k}});
  }
  return log;
}

class WrittenLog : public ::testing::TestWithParam<const char*> {
 protected:
  RecordedLog written_and_read(const RecordedLog& log, const LogOptions& options = {}) const {
    const std::string path = folder_.file("drive");
    log_format_by_name(GetParam()).write(path, log);
    return load_log(path, options);
  }

  TemporaryFolder folder_;
};

// As recorders write CARMEN logs: readings in centimetres, poses with six places.
RecordedLog recording() {
  RecordedLog log;
  for (int k = 0; k < 20; ++k) {
    const double time = 976052857.245834 + 0.1 * k;
    log.measurements.emplace_back(
        Odometry{time, Pose2{0.25 * k, -0.1, (123457 * k - 1000000) / 1e6}});
    LaserScan scan;
    scan.time = time;
    scan.robot_from_laser.planar = {0.78, -0.05, radians(180.0)};
    scan.first_bearing = radians(-90.0);
    scan.bearing_step = radians(0.5);
    scan.max_range = 81.83;
    for (int beam = 0; beam < 361; ++beam)
      scan.ranges.push_back(beam % 20 == 0 ? 81.83 : (37 * beam % 8000 + 2) / 100.0);
    log.measurements.emplace_back(scan);
  }
  return log;
}

TEST_P(WrittenLog, OfARecordingIsReadBackToTheLastBit) {
  const RecordedLog before = recording();
  const RecordedLog after = written_and_read(before);
  EXPECT_TRUE(after.warnings.empty());
  EXPECT_TRUE(carmen_text(after) == carmen_text(before));
}

TEST_P(WrittenLog, IsReadBackButForTheRoundingToFloats) {
  const RecordedLog log = written_and_read(short_log());
  ASSERT_EQ(log.measurements.size(), 8u);
  EXPECT_TRUE(log.warnings.empty());
  for (int k = 0; k < 4; ++k) {
    const double time = 1600000000.0 + 0.125 * k;
    const auto& odometry = std::get<Odometry>(log.measurements[static_cast<std::size_t>(2 * k)]);
    EXPECT_EQ(odometry.time, time);
    EXPECT_THAT(odometry.odometry_from_robot,
                IsNear(Pose2{0.1 * k, 0.0, 0.3 * k}, Tolerance{1e-12, 1e-12}));
    EXPECT_EQ(odometry.turn_velocity, 0.5);
    const auto& scan = std::get<LaserScan>(log.measurements[static_cast<std::size_t>(2 * k + 1)]);
    EXPECT_EQ(scan.ranges[0], 1.1);
    EXPECT_TRUE(scan.is_max_range(1));
    EXPECT_EQ(scan.ranges[2], 0.0);
    EXPECT_TRUE(scan.is_hit(3));
    EXPECT_EQ(scan.remissions, scan_at(time).remissions);
    EXPECT_EQ(scan.beam_period, 0.001);
    EXPECT_EQ(scan.max_range, 8.0);
    EXPECT_THAT(scan.robot_from_laser.planar, IsNear(Pose2{0.25, 0.0, 0.5}, Tolerance{1e-9, 1e-9}));
    EXPECT_EQ(scan.robot_from_laser.z, 0.125);
    EXPECT_THAT(log.true_poses[static_cast<std::size_t>(k)].pose,
                IsNear(Pose2{0.1 * k, 0.01, 0.3 * k}, Tolerance{1e-12, 1e-12}));
  }
}

TEST_P(WrittenLog, OfAWholeTourHasTheSameReadingsInEveryKindOfBag) {
  const RecordedLog log = written_and_read(example_log());
  const std::string other = folder_.file("other.bag");
  write_rosbag1(other, example_log());
  EXPECT_TRUE(carmen_text(log) == carmen_text(load_log(other)));
}

TEST_P(WrittenLog, OfTwoLasersIsReadWhenBothAreNamed) {
  RecordedLog log = short_log();
  LaserScan rear = scan_at(1600000001.0);
  rear.laser = 1;
  rear.robot_from_laser.planar.theta = 3.0;
  log.measurements.emplace_back(rear);
  LogOptions both;
  both.bag.scans = {"/scan", "/scan_2"};
  const RecordedLog read = written_and_read(log, both);
  ASSERT_EQ(read.lasers.size(), 2u);
  EXPECT_NEAR(read.lasers[1].robot_from_laser.theta, 3.0, 1e-9);
}

TEST_P(WrittenLog, WithATiltedLaserKeepsItsMount) {
  RecordedLog log = short_log();
  for (Measurement& m : log.measurements)
    if (auto* scan = std::get_if<LaserScan>(&m)) scan->robot_from_laser.pitch = 0.25;
  const RecordedLog read = written_and_read(log);
  EXPECT_NEAR(std::get<LaserScan>(read.measurements[1]).robot_from_laser.pitch, 0.25, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Bags, WrittenLog, ::testing::Values("ros1", "ros2", "mcap"));

TEST(BagWriter, ABagThatCannotSayAMountOrAStampIsRefused) {
  const TemporaryFolder folder;
  RecordedLog log = short_log();
  std::get<LaserScan>(log.measurements.back()).robot_from_laser.z = 2.0;
  EXPECT_INPUT_ERROR(write_rosbag1(folder.file("a.bag"), log),
                     "a bag cannot say that the mount of a laser changes");
  RecordedLog early = short_log();
  std::get<Odometry>(early.measurements.front()).time = -1.0;
  EXPECT_INPUT_ERROR(write_mcap(folder.file("a.mcap"), early), "a bag has no stamp such as -1 s");
}

TEST(BagWriter, TheFolderOfABagOfRos2HasTheMetadataThatItsReadersAskFor) {
  const TemporaryFolder folder;
  write_rosbag2(folder.file("drive"), short_log());
  const ConfigNode yaml = load_config(folder.file("drive/metadata.yaml"));
  const ConfigNode& about = yaml.at("rosbag2_bagfile_information");
  EXPECT_EQ(about.at("storage_identifier").text(), "sqlite3");
  EXPECT_EQ(about.at("version").text(), "5");
  // Of each time odometry, its transform, a scan and a true pose; and the mount.
  EXPECT_EQ(about.at("message_count").text(), "17");
  EXPECT_EQ(about.at("duration").at("nanoseconds").text(), "375000000");
  EXPECT_EQ(about.at("relative_file_paths").texts().at(0), "drive_0.db3");
  const ConfigNode& topic = about.at("topics_with_message_count").items().at(0);
  EXPECT_EQ(topic.at("topic_metadata").at("name").text(), "/scan");
  EXPECT_EQ(topic.at("topic_metadata").at("type").text(), "sensor_msgs/msg/LaserScan");
  EXPECT_EQ(topic.at("message_count").text(), "4");
}

}  // namespace
}  // namespace mapbed
