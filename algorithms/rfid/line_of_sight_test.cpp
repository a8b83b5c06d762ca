#include "algorithms/rfid/line_of_sight.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// A wall along x = 2 m, 4 m long, with a door from y = -0.5 m to 0.5 m.
OccupancyMap wall_with_a_door() {
  OccupancyMap map(GridFrame{.resolution = 0.1});
  for (int y = -20; y < 20; ++y) {
    if (y < -5 || y >= 5) map.at({20, y}) = known(0.9);
  }
  return map;
}

TEST(LineOfSight, EndsAtWallsAndGoesThroughDoors) {
  const OccupancyMap map = wall_with_a_door();
  const LineOfSight sight(map, {0.0, 0.0}, 8.0);
  EXPECT_TRUE(sight.sees(1.9F, 1.5F));
  EXPECT_FALSE(sight.sees(3.0F, 1.5F));
  EXPECT_FALSE(sight.sees(3.0F, -1.5F));
  EXPECT_TRUE(sight.sees(6.0F, 0.0F));
  EXPECT_TRUE(sight.sees(-7.0F, 1.0F));
  EXPECT_FALSE(sight.sees(-9.0F, 0.0F));  // beyond the reach
}

TEST(LineOfSight, SeesWhatHangsOnAWall) {
  const LineOfSight sight(wall_with_a_door(), {0.0, 1.0}, 8.0);
  EXPECT_TRUE(sight.sees(2.05F, 1.0F));
  EXPECT_TRUE(sight.sees(2.2F, 1.0F));
  EXPECT_FALSE(sight.sees(2.4F, 1.0F));
}

TEST(LineOfSight, WhatIsUnknownHidesNothing) {
  const OccupancyMap map(GridFrame{.resolution = 0.1});
  EXPECT_TRUE(LineOfSight(map, {5.0, 5.0}, 8.0).sees(-1.0F, 5.0F));
}

}  // namespace
}  // namespace mapbed
