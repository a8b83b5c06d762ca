#include "sim/actors/doors.h"

#include <cmath>

#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

World world_with(const Door& door) {
  World world = small_room(6.0, 4.0);
  world.entities.push_back(block("door", {3.45, 2.0}, {0.9, 0.04}));
  world.entities.back().kind = EntityKind::door;
  world.doors.push_back(door);
  world.doors.back().entity = 4;
  world.doors.back().world_from_hinge = {3.0, 2.0, 0.0};
  return world;
}

void pass_time(Doors& doors, std::span<const DoorVisitor> visitors, double seconds) {
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) doors.step(visitors, 0.01);
}

TEST(Doors, OpenForWhoComesNearAndShutBehindHim) {
  Doors doors(world_with({.open_angle = 1.5, .opens_within = 1.2}), Rng(1));
  const DoorVisitor far_away{{0.5, 0.5}};
  pass_time(doors, {&far_away, 1}, 5.0);
  EXPECT_EQ(doors.angle(0), 0.0);

  const DoorVisitor near{{3.45, 0.6}};
  pass_time(doors, {&near, 1}, 3.0);
  EXPECT_DOUBLE_EQ(doors.angle(0), 1.5);

  pass_time(doors, {&far_away, 1}, 6.0);
  EXPECT_EQ(doors.angle(0), 0.0);
}

TEST(Doors, TurnAtTheirSpeed) {
  Doors doors(world_with({.open_angle = -1.5, .turn_speed = 0.5, .opens_within = 1.2}), Rng(1));
  const DoorVisitor near{{3.45, 3.3}};
  pass_time(doors, {&near, 1}, 1.0);
  EXPECT_NEAR(doors.angle(0), -0.5, 0.01);
  EXPECT_TRUE(doors.is_moving(0));
}

TEST(Doors, WaitForWhoStandsInTheLeafsWay) {
  Doors doors(
      world_with({.open_angle = 1.5, .starts_open = true, .mean_open = 0.1, .opens_within = 0.0}),
      Rng(1));
  const DoorVisitor in_the_way{{3.5, 2.3}, 0.25};
  const Wall before = doors.walls()[0];
  pass_time(doors, {&in_the_way, 1}, 3.0);
  const Wall leaf = doors.walls()[0];
  EXPECT_GT((nearest_point(leaf, in_the_way.position) - in_the_way.position).norm(), 0.25);
  EXPECT_NE(leaf.to, before.to);  // it came as near as it could
}

TEST(Doors, ThatOpenAndShutByChanceAreOpenAsOftenAsTheirMeansSay) {
  Doors doors(world_with({.open_angle = 1.5,
                          .turn_speed = 100.0,
                          .mean_open = 2.0,
                          .mean_shut = 6.0,
                          .opens_within = 0.0}),
              Rng(5));
  int open = 0;
  constexpr int kSeconds = 20'000;
  for (int i = 0; i < kSeconds; ++i) {
    pass_time(doors, {}, 1.0);
    open += doors.angle(0) > 0.7 ? 1 : 0;
  }
  // 2500 openings of 2 s +- 2 s in 20000 s: five standard errors of the share are about 0.022.
  EXPECT_NEAR(static_cast<double>(open) / kSeconds, 0.25, 0.022);
}

}  // namespace
}  // namespace mapbed
