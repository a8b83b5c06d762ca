#include "algorithms/input/scan_fusion.h"

#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

const TestLaser kFront{.beams = 181, .max_range = 8.0, .robot_from_laser = {0.2, 0.0, 0.0}};
const TestLaser kRear{.beams = 91,
                      .bearing_step = radians(2.0),
                      .max_range = 8.0,
                      .robot_from_laser = {-0.2, 0.0, kPi}};

LaserScan scan_of_laser(int number, const Pose2& pose, double time) {
  LaserScan scan = scan_of(rectangular_room(6.0, 4.0), pose, number == 0 ? kFront : kRear, time);
  scan.laser = number;
  return scan;
}

TEST(ScanFusion, HasTheHitsOfBothLasersInTheRobotFrame) {
  const Pose2 pose{0.3, -0.2, 0.5};
  const LaserScan front = scan_of_laser(0, pose, 1.0), rear = scan_of_laser(1, pose, 1.0);
  const LaserScan whole = fused({front, rear});
  EXPECT_EQ(whole.time, 1.0);
  std::vector<Eigen::Vector2d> expected = all_hit_points(front, 8.0);
  for (const Eigen::Vector2d& hit : all_hit_points(rear, 8.0)) expected.push_back(hit);
  const std::vector<Eigen::Vector2d> hits = all_hit_points(whole, 8.0);
  ASSERT_EQ(hits.size(), 272U);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_LT((hits[i] - expected[i]).norm(), 1e-9);
}

TEST(ScanFusion, KnowsWhatTheRobotDidBetweenTheStamps) {
  const Trajectory path{{0.0, {}}, {1.0, {1.0, 0.0, 1.0}}};
  const LaserScan front = scan_of_laser(0, *pose_at(path, 0.5), 0.5);
  const LaserScan rear = scan_of_laser(1, *pose_at(path, 0.504), 0.504);
  const LaserScan whole = fused({front, rear}, path);
  for (const Eigen::Vector2d& hit : all_hit_points(whole, 8.0)) {
    const Eigen::Vector2d p = *pose_at(path, 0.5) * hit;
    EXPECT_LT(std::min(std::abs(3.0 - std::abs(p.x())), std::abs(2.0 - std::abs(p.y()))), 1e-9);
  }
}

TEST(ScanFusion, BeamsThatEndNowhereBeforeTheOthersRangeCountAsFailed) {
  const LaserScan near{.laser = 0, .bearing_step = 0.1, .max_range = 4.0, .ranges = {4.0, 1.0}};
  const LaserScan far{.laser = 1, .bearing_step = 0.1, .max_range = 8.0, .ranges = {8.0, 5.0}};
  EXPECT_EQ(fused({near, far}).ranges, (std::vector<double>{0.0, 1.0, 8.0, 5.0}));
}

TEST(ScanFusion, IsOfLevelLasersAtOneInstantAlone) {
  const LaserScan a{.time = 1.0, .laser = 0};
  EXPECT_TRUE(are_of_one_instant(a, {.time = 1.0, .laser = 1}, {}));
  EXPECT_TRUE(are_of_one_instant(a, {.time = 1.004, .laser = 1}, {}));
  EXPECT_FALSE(are_of_one_instant(a, {.time = 1.01, .laser = 1}, {}));
  EXPECT_FALSE(are_of_one_instant(a, {.time = 1.0, .laser = 0}, {}));
  EXPECT_FALSE(
      are_of_one_instant(a, {.time = 1.0, .laser = 1, .robot_from_laser = {.pitch = 0.3}}, {}));
}

}  // namespace
}  // namespace mapbed
