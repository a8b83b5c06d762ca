#include "algorithms/field/surface_map.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

std::vector<SurfacePoint> scattered(int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back({{rng.uniform(-20, 20), rng.uniform(-20, 20)}});
  return points;
}

TEST(SurfaceMap, FindsTheNearestPointInTheCellsAbout) {
  SurfaceMap map(0.1);
  const std::vector<SurfacePoint> points = scattered(4'000, 2);
  map.add(points, Pose2{});
  int found = 0;
  for (const SurfacePoint& probe : scattered(2'000, 3)) {
    const SurfaceMap::Nearest nearest = map.nearest(probe.position);
    double expected = 1e9;
    for (const SurfacePoint& point : points) {
      expected = std::min(expected, (point.position - probe.position).norm());
    }
    if (expected > 0.1) continue;  // may lie outside the nine cells
    ++found;
    ASSERT_TRUE(nearest.found);
    // Points of one cell are averaged, so the mean may lie a cell's diagonal off.
    EXPECT_NEAR(std::hypot(nearest.off_x, nearest.off_y), expected, 0.15);
  }
  EXPECT_GT(found, 100);
}

TEST(SurfaceMap, CopiesDoNotSeeEachOthersWriting) {
  SurfaceMap original(0.1);
  original.add({{{1.02, 1.03}}}, Pose2{});
  SurfaceMap copy = original;
  copy.add({{{1.32, 1.03}}, {{-30.0, 5.0}}}, Pose2{});
  EXPECT_TRUE(copy.nearest({1.33, 1.03}).found);
  EXPECT_FALSE(original.nearest({1.33, 1.03}).found);
  EXPECT_FALSE(original.nearest({-30.0, 5.0}).found);
  EXPECT_TRUE(original.nearest({1.02, 1.03}).found);
}

// A resampled particle costs what it saw differently, not a map.
TEST(SurfaceMap, ManyCopiesTakeTheMemoryOfOneAndOfTheirDifferences) {
  SurfaceMap original(0.1);
  original.add(scattered(4'000, 2), Pose2{});  // on 40 m x 40 m
  std::vector<SurfaceMap> copies(50, original);
  const auto distinct = [&] {
    std::vector<const SurfaceMap*> maps{&original};
    for (const SurfaceMap& copy : copies) maps.push_back(&copy);
    return SurfaceMap::distinct_bytes(maps);
  };
  const std::size_t one = SurfaceMap::distinct_bytes({&original});
  EXPECT_LT(distinct(), 1.1 * static_cast<double>(one));
  for (SurfaceMap& copy : copies) copy.add({{{5.05, 5.05}}, {{5.15, 5.05}}}, Pose2{});
  // Each has a block (64 pointers) and a tile (some 30 cells of 10 bytes, and 216 bytes) of its own
  // now, of a map of 4000 cells.
  EXPECT_GT(one, 40'000U);
  EXPECT_LT(distinct(), one + 50 * 3'000U);
}

TEST(SurfaceMap, KeepsTheMeanOfACellAndOfItsLinesSeenFromAnyPose) {
  SurfaceMap map(0.1);
  const Pose2 pose{-12.34, 56.78, 2.5};
  Rng rng(5);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  const int count = 200;
  const double along = 0.3;  // [rad] of the line, in the map
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d in_map(-3.17 + rng.uniform(-0.02, 0.02), 3.24 + rng.uniform(-0.02, 0.02));
    mean += in_map / count;
    const double turned = 2.0 * (along - pose.theta);
    map.add({{inverse(pose) * in_map, {std::cos(turned), std::sin(turned)}}}, pose);
  }
  const SurfaceMap::Nearest nearest = map.nearest({-3.15, 3.25});
  // Each of the points may be rounded by half of 1/2048 of a cell: less than 5e-3 of it in all.
  EXPECT_NEAR(double{nearest.off_x}, -3.15 - mean.x(), 5e-4);
  EXPECT_NEAR(double{nearest.off_y}, 3.25 - mean.y(), 5e-4);
  EXPECT_NEAR(double{nearest.doubled_x}, std::cos(2.0 * along), 1e-3);
  EXPECT_NEAR(double{nearest.doubled_y}, std::sin(2.0 * along), 1e-3);
}

// Tiles are of 3.2 m, on both sides of zero: nothing is lost or found twice at their borders.
TEST(SurfaceMap, FindsAcrossTheBordersOfTiles) {
  for (const double border : {-6.4, -3.2, 0.0, 3.2}) {
    SurfaceMap map(0.1);
    map.add({{{border - 0.03, border - 0.03}}}, Pose2{});
    const SurfaceMap::Nearest nearest = map.nearest({border + 0.02, border + 0.04});
    ASSERT_TRUE(nearest.found) << border;
    EXPECT_NEAR(double{nearest.off_x}, 0.05, 1e-4);
    EXPECT_NEAR(double{nearest.off_y}, 0.07, 1e-4);
    EXPECT_FALSE(map.nearest({border + 0.12, border + 0.04}).found);
  }
}

TEST(SurfaceMap, OfNothingFindsNothing) {
  EXPECT_FALSE(SurfaceMap(0.1).nearest({0.0, 0.0}).found);
}

}  // namespace
}  // namespace mapbed
