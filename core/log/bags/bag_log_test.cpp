// Which topics and frames of a bag count, and what becomes of its messages.

#include "core/log/bags/bag_log.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_bag.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Tolerance kExact{1e-9, 1e-9};

RecordedLog read(const TestBag& bag, const BagOptions& options = {}) {
  LogOptions all;
  all.bag = options;
  return parse_log("a.bag", bag.bytes(), all);
}

std::string warnings_of(const RecordedLog& log) {
  std::string all;
  for (const LogWarning& warning : log.warnings) all += to_string(warning) + '\n';
  return all;
}

std::vector<LaserScan> scans_of(const RecordedLog& log) {
  std::vector<LaserScan> scans;
  for (const Measurement& m : log.measurements)
    if (const auto* scan = std::get_if<LaserScan>(&m)) scans.push_back(*scan);
  return scans;
}

// Topics.

TEST(TopicsOfABag, TheOnlyLaserIsTaken) {
  const RecordedLog log = read(TestBag().add("/scan", {.time = 1.0}).add("/scan", {.time = 2.0}));
  EXPECT_EQ(scans_of(log).size(), 2u);
  EXPECT_EQ(log.lasers.at(0).source, "/scan");
}

TEST(TopicsOfABag, OfSeveralLasersOneMustBeNamed) {
  const TestBag bag = TestBag().add("/front", {.time = 1.0}).add("/rear", {.time = 1.5});
  EXPECT_INPUT_ERROR(read(bag),
                     "a.bag: has several lasers: /front (1 sensor_msgs/LaserScan), /rear (1 "
                     "sensor_msgs/LaserScan); name one, or all with the front one first: --set "
                     "log.bag.scans='[/front]'");
  EXPECT_EQ(scans_of(read(bag, {.scans = {"/rear"}})).at(0).time, 1.5);
  EXPECT_EQ(scans_of(read(bag, {.scans = {"rear"}})).size(), 1u) << "the slash may be left out";
  const auto both = scans_of(read(bag, {.scans = {"/rear", "/front"}}));
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].laser, 1);
  EXPECT_EQ(both[1].laser, 0);
}

TEST(TopicsOfABag, NamesThatAreNotThereAreTold) {
  const TestBag bag = TestBag().add("/scan", {.time = 1.0}).add_odometry("/odom", 1.0, Pose2{});
  EXPECT_INPUT_ERROR(read(bag, {.scans = {"/scam"}}),
                     "a.bag: has no topic '/scam', as log.bag.scans says; did you mean '/scan'?");
  EXPECT_INPUT_ERROR(read(bag, {.scans = {"/odom"}}),
                     "the topic '/odom' of log.bag.scans is no laser: its messages are "
                     "nav_msgs/Odometry");
  EXPECT_INPUT_ERROR(read(bag, {.odometry = "/scan"}), "is no odometry");
  EXPECT_INPUT_ERROR(read(bag, {.truth = "/vicon"}), "has no topic '/vicon'");
}

TEST(TopicsOfABag, ABagWithoutScansTellsWhatItHas) {
  EXPECT_INPUT_ERROR(read(TestBag().add_odometry("/odom", 1.0, Pose2{})),
                     "a.bag: holds no laser scan; its topics are /odom (1 nav_msgs/Odometry)");
  EXPECT_INPUT_ERROR(read(TestBag()), "a.bag: holds no messages");
}

TEST(TopicsOfABag, OfSeveralKindsOfOdometryOneMustBeNamed) {
  const TestBag bag = TestBag()
                          .add("/scan", {.time = 1.0})
                          .add_odometry("/odom", 1.0, Pose2{1, 0, 0})
                          .add_odometry("/ekf", 1.0, Pose2{2, 0, 0});
  EXPECT_INPUT_ERROR(read(bag),
                     "has several kinds of odometry: /odom (1 nav_msgs/Odometry), /ekf "
                     "(1 nav_msgs/Odometry); name one");
  const RecordedLog log = read(bag, {.odometry = "/ekf"});
  EXPECT_EQ(std::get<Odometry>(log.measurements.at(0)).odometry_from_robot.x, 2.0);
  EXPECT_EQ(read(bag, {.odometry = "none"}).measurements.size(), 1u);
}

TEST(TopicsOfABag, AMessageOfTheSameNameWithOtherFieldsIsRefused) {
  const TestBag bag = TestBag().add_raw("/scan", "sensor_msgs/LaserScan",
                                        "00000000000000000000000000000000", 1.0, "12345678");
  EXPECT_INPUT_ERROR(read(bag),
                     "a.bag: '/scan' is called 'sensor_msgs/LaserScan', but its messages have "
                     "other fields than those of ROS by that name");
}

TEST(TopicsOfABag, TruePosesAreThoseOfTheTopicTruth) {
  const TestBag bag = TestBag()
                          .add("/scan", {.time = 1.0})
                          .add_pose("/truth/pose", 1.0, Pose2{1, 2, 0.5})
                          .add_odometry("/vicon", 1.0, Pose2{3, 0, 0});
  EXPECT_THAT(read(bag).true_poses.at(0).pose, IsNear(Pose2{1, 2, 0.5}, kExact));
  EXPECT_EQ(read(bag, {.truth = "/vicon"}).true_poses.at(0).pose.x, 3.0);
  const TestBag both = TestBag(bag).add_odometry("/odom", 1.0, Pose2{});
  EXPECT_EQ(read(both, {.truth = "/vicon"}).measurements.size(), 2u) << "it is no odometry then";
}

// Frames.

TEST(FramesOfABag, MountsComeFromTransformsAlongTheWholeChain) {
  const RecordedLog log =
      read(TestBag()
               .add_transform("/tf_static", {"base_link", "mast", Pose2{1.0, 0.0, kPi / 2}})
               .add_transform("/tf_static", {"base_footprint", "base_link", Pose2{0.0, 0.5, 0.0}})
               .add_transform("/tf_static", {"mast", "laser", Pose2{0.25, 0.0, 0.0}})
               .add("/scan", {.time = 1.0})
               .add_odometry("/odom", 1.0, Pose2{}, "base_footprint"));
  EXPECT_THAT(scans_of(log).at(0).robot_from_laser.planar,
              IsNear(Pose2{1.0, 0.75, kPi / 2}, kExact));
}

TEST(FramesOfABag, ALaserUpsideDownIsMountedUprightWithItsBeamsTheOtherWayRound) {
  const RecordedLog log =
      read(TestBag()
               .add_transform("/tf_static", {"base_link", "laser", Pose2{0.5, 0.0, 0.25}, kPi})
               .add("/scan", {.time = 1.0})
               .add_odometry("/odom", 1.0, Pose2{}));
  const LaserScan scan = scans_of(log).at(0);
  EXPECT_TRUE(scan.robot_from_laser.is_level());
  EXPECT_THAT(scan.robot_from_laser.planar, IsNear(Pose2{0.5, 0.0, 0.25}, kExact));
  EXPECT_EQ(scan.first_bearing, 1.0);
  EXPECT_EQ(scan.bearing_step, -0.5);
}

TEST(FramesOfABag, ALaserThatLooksDownIsNotLevel) {
  const RecordedLog log =
      read(TestBag()
               .add_transform("/tf_static", {"base_link", "laser", Pose2{}, 0.5})
               .add("/scan", {.time = 1.0})
               .add_odometry("/odom", 1.0, Pose2{}));
  EXPECT_NEAR(scans_of(log).at(0).robot_from_laser.roll, 0.5, 1e-9);
}

TEST(FramesOfABag, WithoutATransformTheLaserIsAtTheRobotsCentreAndThatIsSaid) {
  const TestBag bag = TestBag().add("/scan", {.time = 1.0}).add_odometry("/odom", 1.0, Pose2{});
  const RecordedLog log = read(bag);
  EXPECT_EQ(scans_of(log).at(0).robot_from_laser.planar, Pose2{});
  EXPECT_THAT(warnings_of(log), HasSubstr("no transform tells where the laser's frame 'laser' is "
                                          "on the robot ('base_link')"));
  LogOptions told;
  told.robot_from_laser = {0.25, 0.0, 0.0};
  const RecordedLog again = parse_log("a.bag", bag.bytes(), told);
  EXPECT_EQ(scans_of(again).at(0).robot_from_laser.planar.x, 0.25);
  EXPECT_THAT(again.warnings, IsEmpty());
}

TEST(FramesOfABag, TransformsAreTheOdometryWhereThereIsNoTopicOfIt) {
  TestBag bag;
  bag.add_transform("/tf_static", {"base_link", "laser", Pose2{0.5, 0.0, 0.0}});
  for (int k = 0; k < 3; ++k) {
    bag.add_transform("/tf", {"odom", "base_link", Pose2{0.5 * k, 0, 0}, 0.0, 1.0 + k});
    bag.add_transform("/tf",
                      {"odom", "base_link", Pose2{0.5 * k, 0, 0}, 0.0, 1.0 + k});  // told again
    bag.add("/scan", {.time = 1.5 + k});
  }
  const RecordedLog log = read(bag);
  ASSERT_EQ(log.measurements.size(), 6u);
  EXPECT_EQ(std::get<Odometry>(log.measurements[2]).odometry_from_robot.x, 0.5);
  EXPECT_EQ(scans_of(log).at(0).robot_from_laser.planar.x, 0.5);
  EXPECT_THAT(log.warnings, IsEmpty());
  EXPECT_INPUT_ERROR(read(bag, {.odometry = "tf", .odometry_frame = "map"}),
                     "its transforms tell no odometry: nothing hangs on the frame 'map'");
}

TEST(FramesOfABag, MessagesThatArriveLateAreInTheOrderOfTheirStampsWithoutARemark) {
  const RecordedLog log = read(TestBag()
                                   .add_odometry("/odom", 1.5, Pose2{}, "laser")
                                   .add("/scan", {.time = 1.0, .recorded = 1.6})
                                   .add_odometry("/odom", 2.5, Pose2{}, "laser")
                                   .add("/scan", {.time = 2.0, .recorded = 2.6}));
  EXPECT_THAT(log.warnings, IsEmpty());
  std::vector<double> times;
  for (const Measurement& m : log.measurements) times.push_back(time_of(m));
  EXPECT_THAT(times, ElementsAre(1.0, 1.5, 2.0, 2.5));
}

// Messages.

TEST(MessagesOfABag, AStampOfZeroIsThatOfTheRecording) {
  const RecordedLog log = read(TestBag()
                                   .add("/scan", {.time = 0.0, .recorded = 5.25})
                                   .add("/scan", {.time = 0.0, .recorded = 5.5}));
  EXPECT_EQ(scans_of(log).at(0).time, 5.25);
  EXPECT_THAT(warnings_of(log), HasSubstr("a.bag, message 1: no time stamp on '/scan': the time of "
                                          "recording is taken (2 times)"));
}

TEST(MessagesOfABag, BeamsRunTheWayOfTheirIncrement) {
  const RecordedLog log =
      read(TestBag().add("/scan", {.time = 1.0, .angle_min = 1.0F, .angle_increment = -0.5F}));
  EXPECT_EQ(scans_of(log).at(0).first_bearing, 1.0);
  EXPECT_EQ(scans_of(log).at(0).bearing_step, -0.5);
}

TEST(MessagesOfABag, OneThatIsCutShortIsLeftOutAndNamed) {
  TestBag bag;
  for (int k = 0; k < 12; ++k) bag.add("/scan", {.time = 1.0 + k});
  bag.add_raw("/scan", "", "", 14.0, "too short");
  const RecordedLog log = read(bag);
  EXPECT_EQ(scans_of(log).size(), 12u);
  EXPECT_EQ(warnings_of(log),
            "a.bag, message 13: truncated or garbled message on '/scan': left out\n");
}

TEST(MessagesOfABag, TheFirstOrTheStrongestOfSeveralEchoesCounts) {
  const TestBag bag = TestBag().add_echoes("/echoes", 1.0, {{1.0F, 2.0F}, {3.0F}, {}},
                                           {{10.0F, 20.0F}, {5.0F}, {}});
  const RecordedLog log = read(bag);
  EXPECT_THAT(scans_of(log).at(0).ranges, ElementsAre(1.0, 3.0, 8.0));
  EXPECT_THAT(warnings_of(log), HasSubstr("of beams with several echoes the first, the nearest, "
                                          "counts (log.bag.echo)"));
  const LaserScan strongest = scans_of(read(bag, {.echo = ChosenEcho::strongest})).at(0);
  EXPECT_THAT(strongest.ranges, ElementsAre(2.0, 3.0, 8.0));
  EXPECT_THAT(strongest.remissions, ElementsAre(20.0, 5.0, 0.0));
}

TEST(MessagesOfABag, TakeNoMoreMemoryThanIsAllowed) {
  TestBag bag;
  for (int k = 0; k < 20; ++k) bag.add("/scan", {.time = 1.0 + k});
  LogOptions options;
  options.max_text = 3000.0;
  EXPECT_INPUT_ERROR(parse_log("a.bag", bag.bytes(), options), "a.bag: ");
}

}  // namespace
}  // namespace mapbed
