#include "bench/experiments/localization_blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

// A scan a second along x, at 1 m/s; the robot is taken to be elsewhere by `off` [m].
Trajectory way(int seconds, double off = 0.0) {
  Trajectory path;
  for (int t = 0; t < seconds; ++t) path.push_back({1.0 * t, {1.0 * t, off, 0.0}});
  return path;
}

TEST(LocalizationBlocks, TheMapKnowsNothingOfTheScansThatAreLocalised) {
  // To the right of the robot a wall that it sees in the second block alone.
  TestRoom room({{{12.0, -1.0}, {18.0, -1.0}}, {{-5.0, 2.0}, {40.0, 2.0}}});
  SensorLog log;
  for (const Stamped<Pose2>& at : way(40)) {
    log.push_back(Odometry{.time = at.time, .odometry_from_robot = at.pose});
    log.push_back(scan_of(room, at.pose, {.max_range = 2.5}, at.time));
  }
  const DriveBlocks drive = blocks_of(log, way(40), 10.0, 2.0, {});
  ASSERT_THAT(drive.blocks, SizeIs(2));
  EXPECT_THAT(drive.mapped_from, SizeIs(20));
  EXPECT_THAT(drive.blocks[0].truth, SizeIs(10));
  EXPECT_THAT(drive.blocks[0].log, SizeIs(20));
  EXPECT_EQ(drive.blocks[0].truth.front().time, 10.0);
  EXPECT_FALSE((*drive.map)[drive.map->cell_of({15.0, -0.99})].probability > 0.5F);
  EXPECT_TRUE((*drive.map)[drive.map->cell_of({5.0, 2.0})].probability > 0.5F);
  EXPECT_FALSE(drive.blocks[0].is_near_map);  // 5 m from the nearest pose of the map
}

TEST(LocalizationBlocks, AreNearTheMapWhereTheyDoNotLeaveItsPath) {
  SensorLog log;
  Trajectory path;
  for (int t = 0; t < 40; ++t) {
    path.push_back({1.0 * t, {0.1 * (t % 10), t < 30 ? 0.0 : 5.0, 0.0}});
    log.push_back(scan_of(rectangular_room(20.0, 20.0), path.back().pose, {}, 1.0 * t));
  }
  const DriveBlocks drive = blocks_of(log, path, 10.0, 2.0, {});
  ASSERT_THAT(drive.blocks, SizeIs(2));
  EXPECT_TRUE(drive.blocks[0].is_near_map);
  EXPECT_FALSE(drive.blocks[1].is_near_map);
}

TEST(LocalizationBlocks, ARobotIsFoundFromWhereItIsKnownAndRightUntilTheEnd) {
  Estimate estimate{.trajectory = way(20), .lost = {{0.0, 4.0}}};
  estimate.trajectory[7].pose.y = 1.5;  // known, and wrong
  const BlockResult result = judged(estimate, way(20), 1.0);
  EXPECT_TRUE(result.is_found);
  EXPECT_EQ(result.seconds_to_it, 8.0);
  EXPECT_EQ(result.scans, 20);
  EXPECT_EQ(result.unknown, 5);
  EXPECT_EQ(result.wrongly_known, 1);
  EXPECT_THAT(result.errors, SizeIs(15));
}

TEST(LocalizationBlocks, ARobotThatIsLostOrWrongInTheEndIsNotFound) {
  EXPECT_FALSE(judged({.trajectory = way(20), .lost = {{18.0, 19.0}}}, way(20), 1.0).is_found);
  const BlockResult wrong = judged({.trajectory = way(20, 1.1)}, way(20), 1.0);
  EXPECT_FALSE(wrong.is_found);
  EXPECT_EQ(wrong.wrongly_known, 20);
}

}  // namespace
}  // namespace mapbed
