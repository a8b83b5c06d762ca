#include "sim/actors/doors.h"

#include <algorithm>
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

Obstacle visitor(double x, double y, double radius = 0.3) {
  return {.pose = {x, y, 0.0}, .radius = radius};
}

void pass_time(Doors& doors, std::span<const Obstacle> visitors, double seconds) {
  const SimState state{visitor(-50.0, -50.0), visitors};  // the robot is far away
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) doors.step(0.01, state);
}

Obstacle leaf_of(const Doors& doors) {
  std::vector<Obstacle> leaves;
  doors.append_obstacles(leaves);
  return leaves.at(0);
}

Motion motion_of(const Doors& doors) {
  std::vector<MovingPose> poses;
  doors.append_poses(poses);
  return poses.at(0).motion;
}

TEST(Doors, OpenForWhoComesNearAndShutBehindHim) {
  Doors doors(world_with({.open_angle = 1.5, .opens_within = 1.2}), Rng(1));
  const Obstacle far_away = visitor(0.5, 0.5);
  pass_time(doors, {&far_away, 1}, 5.0);
  EXPECT_EQ(doors.angle(0), 0.0);

  const Obstacle near = visitor(3.45, 0.6);
  pass_time(doors, {&near, 1}, 3.0);
  EXPECT_DOUBLE_EQ(doors.angle(0), 1.5);

  pass_time(doors, {&far_away, 1}, 6.0);
  EXPECT_EQ(doors.angle(0), 0.0);
}

TEST(Doors, TurnAtTheirSpeed) {
  Doors doors(world_with({.open_angle = -1.5, .turn_speed = 0.5, .opens_within = 1.2}), Rng(1));
  const Obstacle near = visitor(3.45, 3.3);
  pass_time(doors, {&near, 1}, 1.0);
  EXPECT_NEAR(doors.angle(0), -0.5, 0.01);
  EXPECT_EQ(motion_of(doors), Motion::moving);
}

TEST(Doors, AreStillOnlyWhereNothingCanMoveThem) {
  EXPECT_EQ(motion_of(Doors(world_with({.opens_within = 0.0}), Rng(1))), Motion::still);
  EXPECT_EQ(motion_of(Doors(world_with({.opens_within = 1.0}), Rng(1))), Motion::waiting);
}

TEST(Doors, TheRobotOpensThemToo) {
  Doors doors(world_with({.open_angle = 1.5, .opens_within = 1.2}), Rng(1));
  for (int i = 0; i < 300; ++i) doors.step(0.01, {visitor(3.45, 0.6)});
  EXPECT_DOUBLE_EQ(doors.angle(0), 1.5);
}

TEST(Doors, WaitForWhoStandsInTheLeafsWay) {
  Doors doors(
      world_with({.open_angle = 1.5, .starts_open = true, .mean_open = 0.1, .opens_within = 0.0}),
      Rng(1));
  const Obstacle in_the_way = visitor(3.5, 2.3, 0.25);
  const Obstacle before = leaf_of(doors);
  pass_time(doors, {&in_the_way, 1}, 3.0);
  const Obstacle leaf = leaf_of(doors);
  const Eigen::Vector2d in_leaf = inverse(leaf.pose) * in_the_way.pose.position();
  const Eigen::Vector2d nearest(std::clamp(in_leaf.x(), 0.0, leaf.length), 0.0);
  EXPECT_GT((nearest - in_leaf).norm(), 0.25);
  EXPECT_NE(leaf.pose, before.pose);  // it came as near as it could
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
  // 2500 openings of 2 s +- 2 s in 20000 s: five standard errors of the fraction are about 0.022.
  EXPECT_NEAR(static_cast<double>(open) / kSeconds, 0.25, 0.022);
}

}  // namespace
}  // namespace mapbed
