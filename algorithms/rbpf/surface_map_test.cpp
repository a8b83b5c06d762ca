#include "algorithms/rbpf/surface_map.h"

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
  map.add(points);
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
  original.add({{{1.02, 1.03}}});
  SurfaceMap copy = original;
  copy.add({{{1.32, 1.03}}, {{-30.0, 5.0}}});
  EXPECT_TRUE(copy.nearest({1.33, 1.03}).found);
  EXPECT_FALSE(original.nearest({1.33, 1.03}).found);
  EXPECT_FALSE(original.nearest({-30.0, 5.0}).found);
  EXPECT_TRUE(original.nearest({1.02, 1.03}).found);
}

// A resampled particle costs what it saw differently, not a map.
TEST(SurfaceMap, ManyCopiesTakeTheMemoryOfOneAndOfTheirDifferences) {
  SurfaceMap original(0.1);
  original.add(scattered(4'000, 2));  // on 40 m x 40 m
  std::vector<SurfaceMap> copies(50, original);
  const auto distinct = [&] {
    std::vector<const SurfaceMap*> maps{&original};
    for (const SurfaceMap& copy : copies) maps.push_back(&copy);
    return SurfaceMap::distinct_bytes(maps);
  };
  const std::size_t one = SurfaceMap::distinct_bytes({&original});
  EXPECT_LT(distinct(), 1.1 * static_cast<double>(one));
  for (SurfaceMap& copy : copies) copy.add({{{5.05, 5.05}}, {{5.15, 5.05}}});
  // Each has a block and a tile of its own now: some kilobytes of a map of more than a megabyte.
  EXPECT_GT(one, 1'000'000U);
  EXPECT_LT(distinct(), one + 50 * 6'000U);
}

TEST(SurfaceMap, OfNothingFindsNothing) {
  EXPECT_FALSE(SurfaceMap(0.1).nearest({0.0, 0.0}).found);
}

}  // namespace
}  // namespace mapbed
