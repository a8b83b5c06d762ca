#include "sim/actors/navigation_map.h"

#include "core/testing/throws_input_error.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

// A room 10 m x 6 m with a wall from the south to y = 4 at x = 5.
World divided_room() {
  World world = small_room(10.0, 6.0);
  world.entities.push_back(block("divider", {5.0, 2.0}, {0.2, 4.0}));
  return world;
}

TEST(NavigationMap, KnowsTheDistanceToTheNearestWall) {
  const NavigationMap plan(divided_room(), 0.02, 1.9);
  EXPECT_NEAR(plan.clearance({2.0, 0.5}), 0.5, 1e-9);
  EXPECT_NEAR(plan.clearance({4.5, 2.0}), 0.4, 1e-9);
  EXPECT_EQ(plan.clearance({2.5, 3.0}), NavigationMap::kReach);
}

TEST(NavigationMap, TheInsideOfSolidsIsNotFree) {
  World world = small_room(10.0, 6.0);
  world.entities.push_back(block("big block", {5.0, 3.0}, {3.0, 3.0}));
  const NavigationMap plan(world, 0.02, 1.9);
  EXPECT_EQ(plan.clearance({5.0, 3.0}), 0.0);
  EXPECT_FALSE(plan.is_straight_way({5.0, 3.0}, {5.2, 3.1}, 0.3));
}

TEST(NavigationMap, AStraightWayNeedsRoomForTheDisc) {
  const NavigationMap plan(divided_room(), 0.02, 1.9);
  EXPECT_TRUE(plan.is_straight_way({1.0, 5.0}, {9.0, 5.0}, 0.9));
  EXPECT_FALSE(plan.is_straight_way({1.0, 5.1}, {9.0, 5.1}, 0.95));
  EXPECT_FALSE(plan.is_straight_way({1.0, 2.0}, {9.0, 2.0}, 0.3));
}

TEST(NavigationMap, TheWayRoundAWallIsFreeAndShort) {
  const NavigationMap plan(divided_room(), 0.02, 1.9);
  const auto way = plan.way({1.0, 1.0}, {9.0, 1.0}, 0.3);
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(way->front(), Vector2d(1.0, 1.0));
  EXPECT_EQ(way->back(), Vector2d(9.0, 1.0));
  double length = 0.0;
  for (std::size_t i = 1; i < way->size(); ++i) {
    EXPECT_TRUE(plan.is_straight_way((*way)[i - 1], (*way)[i], 0.25));
    length += ((*way)[i] - (*way)[i - 1]).norm();
  }
  // Past the divider's end, 0.3 m away from it, twice 5.2 m; a little more for keeping off.
  EXPECT_LT(length, 12.0);
}

TEST(NavigationMap, ThereIsNoWayOutOfAClosedRoom) {
  const NavigationMap plan(small_room(4.0, 4.0), 0.02, 1.9);
  EXPECT_FALSE(plan.way({2.0, 2.0}, {4.7, 2.0}, 0.3).has_value());
}

TEST(NavigationMap, DoorsAndFloorsAreNoObstacles) {
  World world = small_room(4.0, 4.0);
  world.entities.push_back(block("door", {2.0, 2.0}, {0.9, 0.04}));
  world.entities.back().kind = EntityKind::door;
  EXPECT_EQ(NavigationMap(world, 0.02, 1.9).clearance({2.0, 2.1}), NavigationMap::kReach);
}

// 2 km x 2 km are 1e8 cells of 20 cm.
TEST(NavigationMap, RefusesAWorldTooLargeForItsGrid) {
  EXPECT_INPUT_ERROR(NavigationMap(small_room(2000.0, 2000.0), 0.02, 1.9),
                     "too large to walk or drive in: its floor plan measures 2002 m x 2002 m");
}

// The block covers 10 x 10 cells, at each of which its four sides are looked at, and its sides
// alone are in the lists of at least 2 m x 2 kReach / (0.4 m)^2 = 25 blocks each.
TEST(NavigationMap, RefusesThingsThatTakeTooLongOrTooMuchMemoryBeforeTheWork) {
  World world;
  world.name = "block";
  world.entities = {block("block", {0.0, 0.0}, {2.0, 2.0})};
  EXPECT_NO_THROW(NavigationMap(world, 0.02, 1.9, {.looks = 10'000, .near_walls = 1000}));
  const char* message = "world 'block' has too many or too large things to walk or drive about in";
  EXPECT_INPUT_ERROR(NavigationMap(world, 0.02, 1.9, {.looks = 399}), message);
  EXPECT_INPUT_ERROR(NavigationMap(world, 0.02, 1.9, {.near_walls = 99}), message);
}

// 4000 x 4000 cells, each compared with 200 sides.
TEST(NavigationMap, RefusesALargeThingOfManyCorners) {
  World world;
  world.name = "zigzag";
  Extrusion zigzag{.bottom = 0.0, .top = 2.5};
  for (int i = 0; i < 200; ++i) zigzag.outline.emplace_back(i % 2 == 0 ? 0.0 : 800.0, 4.0 * i);
  world.entities = {{.name = "zigzag", .parts = {{"zigzag", zigzag}}}};
  EXPECT_INPUT_ERROR(NavigationMap(world, 0.02, 1.9), "too many or too large things");
}

}  // namespace
}  // namespace mapbed
