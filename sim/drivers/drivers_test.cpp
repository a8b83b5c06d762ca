#include "sim/drivers/drivers.h"

#include <cmath>
#include <ctime>
#include <numbers>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/input_error.h"
#include "core/random.h"
#include "sim/recorder.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;
using ::testing::HasSubstr;

Robot robot_with(DriveKind kind) {
  Robot robot;
  robot.name = "small";
  robot.mass = 10.0;
  robot.height = 0.3;
  robot.footprint = {.length = 0.5, .width = 0.3};
  robot.drive.kind = kind;
  robot.drive.track = 0.24;
  robot.drive.wheel_base = 0.32;
  robot.drive.max_steering = radians(24.0);  // a circle of 0.72 m
  robot.drive.steering_rate = 2.0;
  return robot;
}

// A room with a screen in its middle, and a path around its end that comes back.
World screened_room() {
  World world = small_room(7.0, 5.0);
  world.name = "screened room";
  world.entities.push_back(block("screen", {3.5, 1.75}, {0.2, 3.5}));
  world.paths = {
      {.name = "round", .points = {{{1.2, 1.0}}, {{1.2, 4.2}}, {{5.8, 4.2}}, {{5.8, 1.0}}}},
      {.name = "back", .points = {{{1.2, 2.5}}, {{2.4, 2.5}}, {{1.2, 2.5}}}}};
  return world;
}

// What a drive was like.
struct Drive {
  bool is_done = false;
  double seconds = 0.0;
  double touching = 0.0;       // [s]
  double most_turned = 0.0;    // [rad] from the heading of the start
  double tightest = 0.0;       // [1/m] curvature of the way
  double backwards = 0.0;      // [m]
  std::vector<double> missed;  // [m] of each way-point, at the nearest
};

Drive driven(const World& world, const Robot& robot, const NamedPath& path,
             const std::string& driver_name, const Settings& settings = {}) {
  const Rng rng(5);
  Simulation simulation(world, robot, start_of(path), {}, rng);
  const auto driver = configure_driver(driver_name, settings).make(simulation, path);
  Drive drive;
  drive.missed.assign(path.points.size(), 1e9);
  const double ahead = robot.drive.kind == DriveKind::ackermann ? robot.drive.wheel_base / 2 : 0.0;
  Pose2 last = simulation.now().robot;
  while (!driver->is_done() && simulation.now().time < driver->longest_time()) {
    simulation.step(driver->command(simulation.now().time));
    const Pose2 now = simulation.now().robot;
    const double turned = angle_difference(last.theta, now.theta);
    const Pose2 axle_motion =
        motion_between(last * Pose2{-ahead, 0.0, 0.0}, now * Pose2{-ahead, 0.0, 0.0});
    if (std::abs(axle_motion.x) > 0.001) {
      drive.tightest = std::max(drive.tightest, std::abs(turned / axle_motion.x));
    }
    drive.backwards += std::max(0.0, -axle_motion.x);
    drive.most_turned =
        std::max(drive.most_turned, std::abs(angle_difference(start_of(path).theta, now.theta)));
    drive.touching += simulation.is_touching() ? 0.01 : 0.0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const double distance = (now.position() - path.points[i].position).norm();
      drive.missed[i] = std::min(drive.missed[i], distance);
    }
    last = now;
  }
  drive.is_done = driver->is_done();
  drive.seconds = simulation.now().time;
  return drive;
}

TEST(OmniDriver, KeepsItsHeadingAndDrivesSidewaysToTheEnd) {
  const World world = screened_room();
  const Drive drive = driven(world, robot_with(DriveKind::omni), world.paths[0], "omni");
  EXPECT_TRUE(drive.is_done);
  EXPECT_EQ(drive.touching, 0.0);
  EXPECT_LT(drive.most_turned, 0.02);
  // It arrives within 15 cm; corners are cut by no more than the 0.6 m that it looks ahead.
  EXPECT_LT(drive.missed.back(), 0.16);
  for (const double missed : drive.missed) EXPECT_LT(missed, 0.45);
}

TEST(OmniDriver, FacesItsWayWhereItIsToldTo) {
  const World world = screened_room();
  const Drive drive = driven(world, robot_with(DriveKind::omni), world.paths[0], "omni",
                             {parse_setting("faces_way=true")});
  EXPECT_TRUE(drive.is_done);
  EXPECT_EQ(drive.touching, 0.0);
  EXPECT_NEAR(drive.most_turned, kPi, 0.3);  // from north to south
}

TEST(CarDriver, KeepsToItsTurningCircleAndOffTheWalls) {
  const World world = screened_room();
  const Robot car = robot_with(DriveKind::ackermann);
  const Drive drive = driven(world, car, world.paths[0], "car");
  EXPECT_TRUE(drive.is_done);
  EXPECT_EQ(drive.touching, 0.0);
  EXPECT_LT(drive.tightest, 1.05 / car.drive.turning_radius());
  for (const double missed : drive.missed) EXPECT_LT(missed, 0.3);
}

TEST(CarDriver, BacksUpWhereThereIsNoRoomToTurn) {
  const World world = screened_room();
  const Robot car = robot_with(DriveKind::ackermann);
  const Drive drive = driven(world, car, world.paths[1], "car");  // 3.4 m wide, there and back
  EXPECT_TRUE(drive.is_done);
  EXPECT_EQ(drive.touching, 0.0);
  EXPECT_GT(drive.backwards, 0.3);
  EXPECT_LT(drive.missed[1], 0.3);
}

TEST(CarDriver, APathThatItsTurningCircleDoesNotAllowIsRefused) {
  World world = small_room(7.0, 5.0);
  world.entities.push_back(block("south", {3.5, 1.1}, {0.2, 2.2}));
  world.entities.push_back(block("north", {3.5, 3.775}, {0.2, 2.45}));  // a gap of 35 cm
  const NamedPath path{.name = "through", .points = {{{1.5, 2.375}}, {{5.5, 2.375}}}};
  try {
    driven(world, robot_with(DriveKind::ackermann), path, "car");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("robot 'small' finds no way along path 'through' to "
                                        "(5.50 m, 2.38 m) that its turning circle of 0.79 m"));
  }
}

TEST(CarDriver, ARobotThatTurnsOnTheSpotFollowsItsArcsToo) {
  const World world = screened_room();
  const Drive drive = driven(world, robot_with(DriveKind::differential), world.paths[0], "car");
  EXPECT_TRUE(drive.is_done);
  EXPECT_EQ(drive.touching, 0.0);
}

TEST(CarDriver, WaitsForSomebodyAndPlansAroundHim) {
  World world = small_room(9.0, 5.0);
  world.paths = {{.name = "along", .points = {{{1.0, 2.5}}, {{8.0, 2.5}}}}};
  world.crowd.places = {{.position = {4.5, 2.5}, .radius = 0.01}};
  const Rng rng(3);
  Simulation simulation(world, robot_with(DriveKind::ackermann), start_of(world.paths[0]),
                        {.actors = {.people = {.standing = 1}}}, rng);
  const auto driver = configure_driver("car").make(simulation, world.paths[0]);
  double least = 1e9;
  while (!driver->is_done() && simulation.now().time < 90.0) {
    simulation.step(driver->command(simulation.now().time));
    least = std::min(least, (simulation.now().robot.position() - Vector2d(4.5, 2.5)).norm());
    ASSERT_FALSE(simulation.is_touching());
  }
  EXPECT_TRUE(driver->is_done());
  EXPECT_LT(least, 2.0);  // it went past
}

// A corridor of 1.4 m, with somebody in its middle: 45 cm are left on either side of him.
TEST(CarDriver, WhoStaysInItsWayIsToldAfterItMadeRoomOnce) {
  World world = small_room(9.0, 1.4);
  world.paths = {{.name = "along", .points = {{{1.0, 0.7}}, {{8.0, 0.7}}}}};
  world.crowd.places = {{.position = {5.0, 0.7}, .radius = 0.01}};
  Robot car = robot_with(DriveKind::ackermann);
  car.odometry.rate = 10.0;
  const Rng rng(3);
  Simulation simulation(world, car, start_of(world.paths[0]),
                        {.actors = {.people = {.standing = 1}}}, rng);
  const auto driver = configure_driver("car").make(simulation, world.paths[0]);
  double farthest = 0.0, back = 0.0;  // [m]
  const RecordingSink sink{.reading = [&](const IdealReading& reading) {
    const double x = std::get<IdealOdometry>(reading).truth.x;
    farthest = std::max(farthest, x);
    back = std::max(back, farthest - x);
  }};
  const RecordingEnd end =
      record(simulation, *driver, {.longest = 90.0, .stuck_after = 20.0}, rng, sink);
  EXPECT_FALSE(end.is_complete);
  EXPECT_THAT(end.stuck, HasSubstr("stuck by somebody at ("));
  EXPECT_GT(back, 1.0);
  EXPECT_LT(simulation.now().time,
            60.0);  // 10 s to get there, 12 s before it makes room, 20 s stuck
}

// The map that it plans with has no leaves of doors; this one never opens.
TEST(CarDriver, MakesRoomWhereSomethingStopsItThatItDoesNotSee) {
  World world = small_room(9.0, 2.0);
  world.paths = {{.name = "along", .points = {{{1.0, 1.0}}, {{8.0, 1.0}}}}};
  world.entities.push_back(block("door", {0.9, 0.0}, {1.8, 0.04}));
  world.entities.back().kind = EntityKind::door;
  world.doors.push_back({.entity = static_cast<int>(world.entities.size()) - 1,
                         .world_from_hinge = {5.0, 0.1, kPi / 2.0},
                         .width = 1.8,
                         .opens_within = 0.0});
  Simulation simulation(world, robot_with(DriveKind::ackermann), start_of(world.paths[0]), {},
                        Rng(3));
  const auto driver = configure_driver("car").make(simulation, world.paths[0]);
  double farthest = 0.0, back = 0.0;  // [m]
  while (simulation.now().time < 40.0) {
    simulation.step(driver->command(simulation.now().time));
    const double x = simulation.now().robot.x;
    farthest = std::max(farthest, x);
    back = std::max(back, farthest - x);
  }
  EXPECT_NEAR(farthest, 5.0 - 0.02 - 0.25, 0.05);  // its nose at the leaf
  EXPECT_GT(back, 1.0);
}

// Somebody stands on the goal in a large room: every search for a way round is in vain, and takes
// milliseconds. Without patience it would search at each of its 160 decisions.
TEST(CarDriver, LooksForAWayRoundTheLessOftenTheLongerThereIsNone) {
  World world = small_room(25.0, 25.0);
  world.paths = {{.name = "along", .points = {{{21.0, 12.5}}, {{22.5, 12.5}}}}};
  world.crowd.places = {{.position = {22.5, 12.5}, .radius = 0.01}};
  const Rng rng(3);
  Simulation simulation(world, robot_with(DriveKind::ackermann), start_of(world.paths[0]),
                        {.actors = {.people = {.standing = 1}}}, rng);
  const auto driver =
      configure_driver("car", {parse_setting("patience=0 s")}).make(simulation, world.paths[0]);
  const std::clock_t begin = std::clock();
  while (simulation.now().time < 8.0) simulation.step(driver->command(simulation.now().time));
  EXPECT_FALSE(driver->is_done());
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 2.0);
}

TEST(Drivers, EachDriveHasAUsualDriverThatCanDriveIt) {
  for (const DriveKind kind : {DriveKind::synchro, DriveKind::differential, DriveKind::skid_steer,
                               DriveKind::omni, DriveKind::ackermann}) {
    EXPECT_TRUE(driver_by_name(usual_driver(kind)).can_drive(kind));
  }
  EXPECT_FALSE(driver_by_name("scripted").can_drive(DriveKind::ackermann));
  EXPECT_FALSE(driver_by_name("omni").can_drive(DriveKind::synchro));
}

// How far a robot turned within 30 cm of each point of its path. [rad]
std::vector<double> turned_at_points(const NamedPath& path, const Settings& settings) {
  const World world = screened_room();
  const Robot robot = robot_with(DriveKind::differential);
  const Rng rng(5);
  Simulation simulation(world, robot, start_of(path), {}, rng);
  const auto driver = configure_driver("turning", settings).make(simulation, path);
  std::vector<double> turned(path.points.size(), 0.0);
  double last = simulation.now().robot.theta;
  while (!driver->is_done() && simulation.now().time < driver->longest_time()) {
    simulation.step(driver->command(simulation.now().time));
    const Pose2& now = simulation.now().robot;
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const bool is_there = (now.position() - path.points[i].position).norm() < 0.3;
      if (is_there) turned[i] += angle_difference(last, now.theta);
    }
    last = now.theta;
  }
  EXPECT_TRUE(driver->is_done());
  return turned;
}

TEST(TurningDriver, TurnsRoundAtEachPointOfThePathTheFirstAndTheLastAsWell) {
  const NamedPath path{.name = "ahead", .points = {{{1.2, 4.2}}, {{2.6, 4.2}}, {{4.0, 4.2}}}};
  const double round = 2.0 * std::numbers::pi;
  for (const double turned : turned_at_points(path, {})) EXPECT_NEAR(turned, round, 0.15);
  for (const double turned : turned_at_points(path, {{"turns", "-2", {}}})) {
    EXPECT_NEAR(turned, -2.0 * round, 0.15);
  }
}

}  // namespace
}  // namespace mapbed
