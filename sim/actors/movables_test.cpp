#include "sim/actors/movables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr int kFirst = 40;  // id of the first one's entity

// A crate of 40 cm x 40 cm that goes between two places 2 m apart at 0.5 m/s.
World world_with_crate(double mean_rest) {
  World world = small_room(6.0, 4.0);
  Entity crate = block("crate", {1.0, 2.0}, {0.4, 0.4});
  crate.kind = EntityKind::movable;
  world.movables.push_back(
      {.entity = crate, .places = {{1.0, 2.0}, {3.0, 2.0}}, .speed = 0.5, .mean_rest = mean_rest});
  return world;
}

Obstacle disc(double x, double y) {
  return {.pose = {x, y, 0.0}, .radius = 0.3};
}

void pass_time(Movables& movables, double seconds, const Obstacle& robot = disc(-50.0, -50.0)) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds * 100.0)); ++i) {
    std::vector<Obstacle> obstacles;  // as the simulation has them: itself among them
    movables.append_obstacles(obstacles);
    movables.step(0.01, {robot, obstacles});
  }
}

MovingPose pose_of(const Movables& movables) {
  std::vector<MovingPose> poses;
  movables.append_poses(poses);
  EXPECT_THAT(poses, SizeIs(1));
  return poses.at(0);
}

double x_of(const Movables& movables) {
  return pose_of(movables).world_from_part.position.x();
}

TEST(Movables, GoToTheirNextPlaceAtTheirSpeedAndBack) {
  Movables movables(world_with_crate(1e-6), kFirst, Rng(1));
  EXPECT_EQ(pose_of(movables).entity, kFirst);
  pass_time(movables, 2.0);
  EXPECT_NEAR(x_of(movables), 2.0, 0.02);  // 1 m at 0.5 m/s
  EXPECT_EQ(pose_of(movables).motion, Motion::moving);
  pass_time(movables, 4.0);
  EXPECT_NEAR(x_of(movables), 2.0, 0.04);  // 1 m on to its place, and 1 m back
  pass_time(movables, 1.0);
  EXPECT_NEAR(x_of(movables), 1.5, 0.04);
}

TEST(Movables, RestInBetween) {
  Movables movables(world_with_crate(1e6), kFirst, Rng(1));
  pass_time(movables, 20.0);
  EXPECT_EQ(x_of(movables), 1.0);
  EXPECT_EQ(pose_of(movables).motion, Motion::waiting);
}

TEST(Movables, WaitForWhoIsInTheWay) {
  Movables movables(world_with_crate(1e-6), kFirst, Rng(1));
  pass_time(movables, 10.0, disc(2.5, 2.0));
  // The circle about the crate has a radius of 0.2 sqrt(2) = 0.28 m, and keeps 0.1 m from the
  // robot.
  EXPECT_NEAR(x_of(movables), 2.5 - 0.3 - 0.283 - 0.1, 0.01);
  EXPECT_EQ(pose_of(movables).motion, Motion::waiting);
  pass_time(movables, 1.0);
  EXPECT_GT(x_of(movables), 2.2) << "goes on when the way is free";
}

TEST(Movables, WithOnePlaceNeverMove) {
  World world = world_with_crate(1e-6);
  world.movables.front().places.resize(1);
  Movables movables(world, kFirst, Rng(1));
  pass_time(movables, 5.0);
  EXPECT_EQ(x_of(movables), 1.0);
  EXPECT_EQ(pose_of(movables).motion, Motion::still);
}

TEST(Movables, AreNoneWhereTheWorldHasNone) {
  const Movables movables(small_room(6.0, 4.0), kFirst, Rng(1));
  EXPECT_THAT(movables.entities(), IsEmpty());
}

}  // namespace
}  // namespace mapbed
