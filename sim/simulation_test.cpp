#include "sim/simulation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "core/testing/throws_input_error.h"
#include "sim/actors/crowd.h"
#include "sim/drivers/scripted_driver.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

Robot round_robot() {
  Robot robot;
  robot.name = "round";
  robot.mass = 20.0;
  robot.height = 0.5;
  robot.footprint.radius = 0.25;
  return robot;
}

// Two rooms with a door between them at x = 5, hinged at (5, 2.5), and a walk from one to the
// other.
World two_rooms() {
  World world = small_room(10.0, 6.0);
  world.entities.push_back(block("wall", {5.0, 1.25}, {0.2, 2.5}));
  world.entities.push_back(block("wall", {5.0, 4.75}, {0.2, 2.5}));
  Entity leaf{.name = "door", .kind = EntityKind::door};
  leaf.parts = {{"leaf", Box{{1.0, 0.04, 2.0}}, upright({0.5, 0.0, 0.0}, 1.0), 0}};
  world.entities.push_back(leaf);
  world.doors = {{.name = "door",
                  .entity = static_cast<int>(world.entities.size()) - 1,
                  .world_from_hinge = {5.0, 2.5, 1.5707963267948966},
                  .width = 1.0,
                  .opens_within = 1.5}};
  world.crowd = {.pause_fraction = 0.0,
                 .group_fraction = 0.0,
                 .routes = {{.name = "through", .points = {{1.5, 3.0}, {8.5, 3.0}}}}};
  return world;
}

// Distance of a point from a door's leaf as it stands.
double distance_to_leaf(const Pose2& world_from_leaf, double width, const Vector2d& point) {
  const Vector2d in_leaf = inverse(world_from_leaf) * point;
  return (in_leaf - Vector2d(std::clamp(in_leaf.x(), 0.0, width), 0.0)).norm();
}

TEST(Simulation, WalkersPassADoorWhenItIsOpenAndNeverItsLeafOrTheWall) {
  const World world = two_rooms();
  Simulation simulation(world, round_robot(), {1.0, 0.8, 0.0},
                        {.actors = {.people = {.walkers = 2}}}, Rng(2));
  const NavigationMap map(world, 0.02, 1.9);
  std::vector<double> last_x(2, 0.0);
  int passages = 0;
  for (int i = 0; i < 6000; ++i) {
    simulation.step({});
    const Obstacle& leaf = simulation.obstacles()[0];
    for (std::size_t k = 0; k < 2; ++k) {
      const Obstacle& person = simulation.obstacles()[1 + k];
      const Vector2d p = person.pose.position();
      ASSERT_GT(map.clearance(p), 0.5 * person.radius);
      ASSERT_GT(distance_to_leaf(leaf.pose, 1.0, p), 0.1);
      const bool passes = i > 0 && (last_x[k] - 5.0) * (p.x() - 5.0) < 0.0;
      last_x[k] = p.x();
      if (!passes) continue;
      ++passages;
      EXPECT_GT(p.y(), 2.5);  // between the posts
      EXPECT_LT(p.y(), 3.5);
      EXPECT_GT(std::abs(leaf.pose.theta - 1.5707963), 0.7);  // the leaf has swung aside
    }
  }
  // 7 m at about 1.1 m/s to and fro for a minute, less what waiting at the door costs.
  EXPECT_GE(passages, 6);
  EXPECT_LE(passages, 2 * 10);
}

TEST(Simulation, ASweepMayTakeAsLongAsItsMirror) {
  Robot robot = round_robot();
  LaserModel laser;
  laser.mirror_rate = 0.5;  // half a turn takes a second
  robot.sensors = {{.name = "front", .model = laser}};
  Simulation simulation(small_room(6.0, 4.0), robot, {3.0, 2.0, 0.0}, {}, Rng(1));
  for (int i = 0; i < 250; ++i) simulation.step({.turn_velocity = 0.3});
  const Simulation::Sweep sweep = simulation.sweep(0, 1.5, 0);
  EXPECT_EQ(sweep.truth.beams.size(), 180u);
  EXPECT_NEAR(sweep.truth.time, 1.5, 0.01);  // when its first beam was sent
}

TEST(Simulation, NobodyGetsIntoARobotThatDrives) {
  World world = small_room(12.0, 4.0);
  world.paths = {{.name = "along", .points = {{{1.0, 2.0}}, {{11.0, 2.0}}, {{1.0, 2.0}}}}};
  world.crowd.routes = {{.name = "along", .points = {{1.0, 2.0}, {11.0, 2.0}}}};
  world.crowd.places = {{.position = {6.0, 1.0}, .radius = 0.3}};
  const Robot robot = round_robot();
  const CrowdOptions people{.walkers = 3, .standing = 1, .blockers = 1};
  Simulation simulation(world, robot, start_of(world.paths[0]), {.actors = {.people = people}},
                        Rng(4));
  ScriptedDriver driver(simulation, world.paths[0]);
  double nearest = 100.0;
  for (int i = 0; i < 6000 && !driver.is_done(); ++i) {
    simulation.step(driver.command(simulation.now().time));
    for (const Obstacle& person : simulation.obstacles()) {
      const double gap = (person.pose.position() - simulation.now().robot.position()).norm();
      nearest = std::min(nearest, gap - robot.footprint.radius);
    }
  }
  EXPECT_GT(nearest, 0.15);  // [m] from a body's middle to the robot's side: no leg under it
  EXPECT_LT(nearest, 1.0);   // they did meet
}

TEST(Simulation, WhoWalksAloneDoesSoAtHisDrawnSpeed) {
  World world = small_room(60.0, 6.0);
  world.crowd = {.pause_fraction = 0.0,
                 .group_fraction = 0.0,
                 .routes = {{.name = "along", .points = {{1.0, 3.0}, {59.0, 3.0}}}}};
  constexpr int kWalkers = 100;
  Moments speeds;
  for (std::uint64_t seed = 0; seed < kWalkers; ++seed) {
    const NavigationMap map(world, 0.02, 1.9);
    const Obstacle robot{.pose = {-50.0, 0.0, 0.0}, .radius = 0.3};
    Crowd crowd(world, map, robot, {.walkers = 1, .mean_speed = 1.1, .speed_sigma = 0.1}, 0,
                Rng(seed));
    // The fastest of five seconds: he may have to turn round at an end of the route.
    double speed = 0.0;
    for (int i = 0; i < 500; ++i) {
      crowd.step(0.01, {robot});
      speed = std::max(speed, crowd.person(0).body.velocity.norm());
    }
    speeds.add(speed);
  }
  EXPECT_NEAR(speeds.mean(), 1.1, 5 * 0.1 / std::sqrt(kWalkers));
  EXPECT_NEAR(speeds.sigma(), 0.1, 5 * 0.1 / std::sqrt(2.0 * kWalkers));
}

// A sweep of a second in one slice: who walks by is seen where he was half a second after it began.
TEST(Simulation, WhatMovesStandsAsInTheMiddleOfASlice) {
  World world = small_room(20.0, 4.0);
  world.crowd = {.pause_fraction = 0.0,
                 .group_fraction = 0.0,
                 .routes = {{.name = "along", .points = {{1.0, 1.0}, {19.0, 1.0}}}}};
  Robot robot = round_robot();
  LaserModel laser;
  laser.beams = 1800;
  laser.bearing_step = -laser.first_bearing / 900;
  laser.max_range = 50.0;
  laser.mirror_rate = 0.5;
  laser.aperture = laser.divergence = 0.0;
  robot.sensors = {{.name = "front", .robot_from_sensor = {.z = 0.4}, .model = laser}};
  const Pose2 stands{10.0, 3.2, -1.5707963267948966};  // looks across the room
  Simulation simulation(world, robot, stands,
                        {.sweep_slices = 1, .actors = {.people = {.walkers = 1}}}, Rng(1));
  for (int i = 0; i < 400; ++i) simulation.step({});
  const Situation middle = simulation.at(3.5 - 0.5 / 1800);

  const Simulation::Sweep sweep = simulation.sweep(0, 3.0, 0);

  int seen = 0;
  for (std::size_t k = 0; k < sweep.truth.beams.size(); ++k) {
    const BeamTruth& beam = sweep.truth.beams[k];
    if (beam.entity < 4) continue;  // a wall
    ++seen;
    const double angle =
        stands.theta + laser.first_bearing + static_cast<double>(k) * laser.bearing_step;
    const Vector2d hit =
        stands.position() + double{beam.range} * Vector2d(std::cos(angle), std::sin(angle));
    const auto part = std::find_if(middle.moving.begin(), middle.moving.end(), [&](const auto& p) {
      return p.entity == beam.entity && p.part == beam.part;
    });
    ASSERT_NE(part, middle.moving.end());
    const auto index = static_cast<std::size_t>(beam.part);
    const Geometry& geometry = simulation.entity(beam.entity).parts[index].geometry;
    const Vector2d from_axis = hit - part->world_from_part.position.head<2>();
    EXPECT_NEAR(from_axis.norm(), std::get<Cylinder>(geometry).radius, 1e-3) << k;
  }
  EXPECT_GT(seen, 10);
}

// A mirror that turns once in 10^6 s sweeps 180 beams for half of that, 50 million steps of 10 ms.
TEST(Simulation, RefusesASweepSoSlowThatNobodyCanRememberWhereThingsWere) {
  Robot robot = round_robot();
  LaserModel laser{.beams = 180, .bearing_step = radians(1.0), .mirror_rate = 1e-6};
  robot.sensors = {{.name = "front", .model = laser}};
  EXPECT_INPUT_ERROR(Simulation(small_room(10.0, 6.0), robot, {2.0, 2.0, 0.0}, {}, Rng(1)),
                     "a sweep takes 4.97e+05 s, and to remember for so long where everything was");
}

}  // namespace
}  // namespace mapbed
