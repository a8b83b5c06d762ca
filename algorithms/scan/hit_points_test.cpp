#include "algorithms/scan/hit_points.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

TEST(HitPoints, LeaveOutWhatHitNothingAndWhatIsTooFar) {
  LaserScan scan{.bearing_step = 0.1, .max_range = 8.0};
  scan.ranges = {1.0, 8.0, 0.0, 5.0, 2.0};
  EXPECT_EQ(hit_points(scan, {.max_range = 4.0}).size(), 2U);
}

TEST(HitPoints, KnowTheWeightsOfTheirBeams) {
  LaserScan scan{.bearing_step = 0.1, .max_range = 8.0};
  scan.ranges = {1.0, 8.0, 0.0, 5.0, 2.0};
  const std::vector<float> weights{0.1F, 0.2F, 0.3F, 0.4F, 0.5F};
  const HitPointOptions near{.max_range = 4.0};
  EXPECT_EQ(hit_point_weights(scan, near, weights), (std::vector<float>{0.1F, 0.5F}));
  EXPECT_TRUE(hit_point_weights(scan, near, {}).empty());
}

TEST(HitPoints, StandInTheRobotFrame) {
  LaserScan scan{
      .robot_from_laser = {.planar = {0.5, 0.0, kPi}}, .bearing_step = 0.1, .max_range = 8.0};
  scan.ranges = {2.0};
  EXPECT_LT((hit_points(scan, {})[0] - Eigen::Vector2d(-1.5, 0.0)).norm(), 1e-12);
}

// Seven metres ahead the hits on a wall 1 m beside the robot lie 0.9 m apart.
}  // namespace
}  // namespace mapbed
