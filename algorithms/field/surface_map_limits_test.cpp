// Cells hold counts of 16 bits, and coordinates may be negative or far away.

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/field/surface_map.h"

namespace mapbed {
namespace {

double distance_to_surface(const SurfaceMap& map, const Eigen::Vector2d& point) {
  const SurfaceMap::Nearest nearest = map.nearest(point);
  EXPECT_TRUE(nearest.found);
  return std::hypot(nearest.off_x, nearest.off_y);
}

TEST(SurfaceMapLimits, AWallThatIsSeenForHoursStaysWhereItIs) {
  SurfaceMap map(0.1);
  const SurfacePoint point{{1.03, 2.07}};
  map.add(std::vector<SurfacePoint>(65'536, point), Pose2{});  // 2^16: one more than a count
  EXPECT_NEAR(distance_to_surface(map, point.position), 0.0, 1e-4);
}

TEST(SurfaceMapLimits, TheMeanOfItsPointsStandsForACell) {
  SurfaceMap map(0.1);
  map.add({{{1.01, 1.05}}, {{1.03, 1.05}}, {{1.08, 1.05}}}, Pose2{});
  EXPECT_NEAR(distance_to_surface(map, {1.04, 1.05}), 0.0, 1e-4);
}

TEST(SurfaceMapLimits, TheLineOfACellIsTheMeanOfItsPointsLines) {
  SurfaceMap map(0.1);
  map.add({{{1.05, 1.05}, {-0.6, 0.8}}, {{1.05, 1.05}, {-0.8, 0.6}}}, Pose2{});
  const SurfaceMap::Nearest nearest = map.nearest({1.05, 1.05});
  EXPECT_NEAR(nearest.doubled_x, -0.7, 1e-4);
  EXPECT_NEAR(nearest.doubled_y, 0.7, 1e-4);
}

// Of any tile and block, also where the map grows to all sides.
TEST(SurfaceMapLimits, EverywhereIsLikeAtTheOrigin) {
  SurfaceMap map(0.1);
  for (const double x : {0.03, -0.03, 51.23, -51.23, 900.07, -900.07}) {
    for (const double y : {0.05, -0.05, -77.77, 1200.01}) map.add({{{x, y}}}, Pose2{});
  }
  for (const double x : {0.03, -0.03, 51.23, -51.23, 900.07, -900.07}) {
    for (const double y : {0.05, -0.05, -77.77, 1200.01}) {
      EXPECT_NEAR(distance_to_surface(map, {x, y}), 0.0, 1e-3) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace mapbed
