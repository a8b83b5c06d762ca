#include "algorithms/scan/hit_points.h"

#include <cmath>
#include <vector>

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

// On an arc of 1 m, where neighbouring hits lie 2 cm apart.
TEST(HitPoints, LieApartAsFarAsTheySayAndKeepTheirWeights) {
  LaserScan scan{.bearing_step = 0.02, .max_range = 8.0};
  scan.ranges.assign(100, 1.0);
  std::vector<float> weights;
  for (int beam = 0; beam < 100; ++beam) weights.push_back(0.01F * static_cast<float>(beam));
  const HitPointOptions options{.min_spacing = 0.05};
  const std::vector<Eigen::Vector2d> points = hit_points(scan, options);
  const std::vector<float> kept = hit_point_weights(scan, options, weights);
  ASSERT_EQ(points.size(), 34U);  // every third one: 6 cm
  ASSERT_EQ(kept.size(), 34U);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR((points[i] - points[i - 1]).norm(), 2.0 * std::sin(0.03), 1e-9);
    EXPECT_EQ(kept[i], weights[3 * i]);
  }
}

TEST(HitPoints, AreNoMoreThanAskedForAndSpreadOverTheScan) {
  LaserScan scan{.bearing_step = 0.02, .max_range = 8.0};
  scan.ranges.assign(100, 1.0);
  const std::vector<Eigen::Vector2d> points =
      hit_points(scan, {.min_spacing = 0.0, .max_points = 10});
  ASSERT_EQ(points.size(), 10U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double bearing = 0.2 * static_cast<double>(i);
    EXPECT_LT((points[i] - Eigen::Vector2d(std::cos(bearing), std::sin(bearing))).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace mapbed
