#include "algorithms/scan_matching/icp_matcher.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// A line from a to b with a point every 2 cm, all of which know their direction.
void add_wall(std::vector<SurfacePoint>& map, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d doubled(along.x() * along.x() - along.y() * along.y(),
                                2.0 * along.x() * along.y());
  const int steps = static_cast<int>((b - a).norm() / 0.02);
  for (int i = 0; i <= steps; ++i) map.push_back({a + 0.02 * i * along, doubled});
}

std::vector<SurfacePoint> corner_of_walls() {
  std::vector<SurfacePoint> map;
  add_wall(map, {-2.0, 2.0}, {3.0, 2.0});
  add_wall(map, {3.0, -1.5}, {3.0, 2.0});
  add_wall(map, {-2.0, -1.5}, {1.0, -1.0});
  return map;
}

// Every seventh point of the map as a robot there sees it.
Points seen_from(const Pose2& map_from_robot, const std::vector<SurfacePoint>& map) {
  Points points;
  for (std::size_t i = 3; i < map.size(); i += 7) {
    points.emplace_back(inverse(map_from_robot) * map[i].position);
  }
  return points;
}

class IcpFindsADisplacement : public ::testing::TestWithParam<Pose2> {};

// Three walls leave one pose. Without a prior and without noise the last step tells the error: it
// is below 0.5 mm, and the steps of Gauss-Newton shrink with their square.
TEST_P(IcpFindsADisplacement, ThatWasPutThereWhereverTheRobotIs) {
  const Pose2 truth{0.3, -0.2, 2.9};  // across the wrap of angles with some of the turns
  const std::vector<SurfacePoint> map = corner_of_walls();
  const PosePrior prediction{.mean = truth * GetParam()};
  const ScanMatch match = match_icp(seen_from(truth, map), IcpMap(map), prediction);
  EXPECT_THAT(match.map_from_robot, IsNear(truth, Tolerance{2e-5, 1e-5}));
  EXPECT_TRUE(match.trustworthy);
  EXPECT_EQ(match.inlier_ratio, 1.0);
  EXPECT_NEAR(match.log_likelihood, 0.0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(IcpMatcher, IcpFindsADisplacement,
                         ::testing::Values(Pose2{}, Pose2{0.1, 0, 0}, Pose2{0, -0.1, 0},
                                           Pose2{0, 0, 0.05}, Pose2{0, 0, -0.05},
                                           Pose2{-0.08, 0.06, 0.04}));

// One wall says how far off it is and how the robot is turned, and nothing of the way along it.
TEST(IcpMatcher, AlongASingleWallThePriorDecides) {
  std::vector<SurfacePoint> map;
  add_wall(map, {-4.0, 1.0}, {4.0, 1.0});
  Points points;
  for (int i = -20; i <= 20; ++i) points.emplace_back(0.1 * i, 1.0);  // from the origin
  const PosePrior prediction = independent_prior({0.07, 0.05, 0.02}, 10.0, 10.0, 10.0);
  const ScanMatch match = match_icp(points, IcpMap(map), prediction);
  EXPECT_NEAR(match.map_from_robot.y, 0.0, 1e-4);
  EXPECT_NEAR(match.map_from_robot.theta, 0.0, 1e-4);
  EXPECT_NEAR(match.map_from_robot.x, 0.07, 2e-3);  // turned about the robot: 0.05 sin(0.02)
}

TEST(IcpMatcher, PointsThatPairWithNothingCountAgainstTheMatch) {
  const std::vector<SurfacePoint> map = corner_of_walls();
  Points points = seen_from({}, map);
  const std::size_t paired = points.size();
  for (std::size_t i = 0; i < paired; ++i) points.emplace_back(8.0, 0.1 * static_cast<double>(i));
  const ScanMatch half = match_icp(points, IcpMap(map), {});
  EXPECT_DOUBLE_EQ(half.inlier_ratio, 0.5);
  EXPECT_TRUE(half.trustworthy);  // 0.5 and more
  points.emplace_back(9.0, 0.0);
  EXPECT_FALSE(match_icp(points, IcpMap(map), {}).trustworthy);
}

TEST(IcpMatcher, KeepsThePredictionWhenNothingWasHit) {
  const PosePrior prediction{.mean = {1.0, 2.0, 0.5}};
  const ScanMatch match = match_icp({}, IcpMap(corner_of_walls()), prediction);
  EXPECT_EQ(match.map_from_robot, prediction.mean);
  EXPECT_FALSE(match.trustworthy);
}

// A wall 1 m to the left, and somebody 0.2 m before it who covers a fifth of the scan. Least
// squares would move the robot by 0.2 m / 5; by Cauchy's weights each of those pulls by d / (1 + (d
// / s)^2).
TEST(IcpMatcher, WhatStandsBeforeAWallPullsLittle) {
  std::vector<SurfacePoint> map;
  add_wall(map, {-4.0, 1.0}, {4.0, 1.0});
  Points points;
  for (int i = -20; i < 20; ++i) points.emplace_back(0.1 * i, 1.0);
  for (int i = -20; i < 20; i += 4) points.emplace_back(0.1 * i, 0.8);
  const PosePrior prediction = independent_prior({}, 0.1, 10.0, 10.0);
  const ScanMatch match = match_icp(points, IcpMap(map), prediction);
  const double sigmas = 0.2 / IcpMatcherOptions{}.sigma;
  const double pull = 10.0 * 0.2 / (1.0 + sigmas * sigmas);
  EXPECT_NEAR(match.map_from_robot.y, pull / 40.0, 0.2 * pull / 40.0);
}

TEST(IcpMatcher, PairsReachAsFarAsTheyMay) {
  std::vector<SurfacePoint> map;
  add_wall(map, {-1.0, 0.0}, {1.0, 0.0});
  const IcpMap tree(map);
  EXPECT_NE(tree.nearest({0.0, 0.49}, 0.5), nullptr);
  EXPECT_EQ(tree.nearest({0.0, 0.51}, 0.5), nullptr);
  EXPECT_NE(tree.nearest({0.0, 1.9}, 2.0), nullptr);
  EXPECT_EQ(tree.nearest({0.0, 2.1}, 2.0), nullptr);
}

}  // namespace
}  // namespace mapbed
