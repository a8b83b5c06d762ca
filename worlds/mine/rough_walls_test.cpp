#include "worlds/mine/rough_walls.h"

#include <cmath>

#include <gtest/gtest.h>

#include "worlds/geometry/footprint.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

WallRelief smooth() {
  Rng rng(1);
  return {0.0, rng};
}

// [m] from a point to the nearest wall.
double room_at(const World& world, const Vector2d& point) {
  double least = HUGE_VAL;
  for (const Footprint& footprint : footprints(world, 0.3, 0.4)) {
    least = std::min(least, distance_to(footprint, point));
  }
  return least;
}

World cross_of(const WallRelief& relief) {
  World world;
  add_rough_walls(world, "rock", {{{-10.0, 0.0}, {10.0, 0.0}, 3.0}, {{0.0, -8.0}, {0.0, 8.0}, 2.0}},
                  relief, "stone", 0.25);
  return world;
}

TEST(RoughWalls, StandAsFarFromTheMiddleAsTheCorridorIsWide) {
  const World world = cross_of(smooth());
  EXPECT_NEAR(room_at(world, {-6.0, 0.0}), 1.5, 0.01);
  EXPECT_NEAR(room_at(world, {0.0, 6.0}), 1.0, 0.01);
  EXPECT_NEAR(room_at(world, {0.0, 0.0}), std::hypot(1.5, 1.0), 0.15) << "open to four sides";
}

TEST(RoughWalls, LeaveNoHole) {
  const World world = cross_of(smooth());
  // Round the end of the corridor, 1.5 m about (10, 0).
  for (double angle = -1.5; angle < 1.5; angle += 0.01) {
    const Vector2d end(10.0 + 1.55 * std::cos(angle), 1.55 * std::sin(angle));
    EXPECT_LT(room_at(world, end), 0.03) << angle;
  }
}

TEST(RoughWalls, ReliefHasTheSpreadThatWasAskedFor) {
  Rng rng(3);
  const WallRelief relief(0.2, rng);
  double sum = 0.0, squares = 0.0;
  constexpr int kSide = 200;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double value = relief.at({0.7 * x, 0.7 * y});
      sum += value;
      squares += value * value;
    }
  }
  constexpr double kCount = kSide * kSide;
  EXPECT_NEAR(sum / kCount, 0.0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.2, 0.01);
}

TEST(RoughWalls, FollowTheRelief) {
  Rng rng(3);
  const WallRelief relief(0.2, rng);
  const World world = cross_of(relief);
  for (const double x : {-8.0, -6.0, -4.0, 4.0, 6.0, 8.0}) {
    // The wall stands where its distance from the middle less the relief there is half the width.
    double y = 1.5;
    for (int i = 0; i < 50; ++i) y = 1.5 + relief.at({x, y});
    EXPECT_LT(room_at(world, {x, y}), 0.06) << x;
  }
}

}  // namespace
}  // namespace mapbed
