#include "sim/physics/planar_physics.h"

#include <cmath>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

constexpr double kStep = 0.01;  // [s]

Robot round_robot() {
  Robot robot;
  robot.mass = 20.0;
  robot.footprint.radius = 0.25;
  return robot;
}

void drive(PlanarPhysics& physics, const DriveCommand& command, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
    physics.step(command, kStep);
  }
}

TEST(PlanarPhysics, DrivesAsTold) {
  PlanarPhysics physics(small_room(6.0, 4.0), round_robot(), {1.0, 2.0, 0.0}, Rng(1));
  drive(physics, {.forward_velocity = 0.5}, 3.0);
  // Speeding up to 0.5 m/s at 0.5 m/s^2 costs 0.25 m; slip less than 1 cm.
  EXPECT_THAT(physics.robot(), IsNear(Pose2{1.0 + 1.5 - 0.25, 2.0, 0.0}, Tolerance{0.01, 0.01}));
  EXPECT_NEAR(physics.robot_velocity().forward, 0.5, 0.005);
  EXPECT_FALSE(physics.is_touching());
}

TEST(PlanarPhysics, AWallStopsTheRobotAndItsWheelsSpin) {
  PlanarPhysics physics(small_room(6.0, 4.0), round_robot(), {5.0, 2.0, 0.0}, Rng(1));
  drive(physics, {.forward_velocity = 0.5}, 4.0);
  EXPECT_NEAR(physics.robot().x, 5.75, 0.02);  // Box2D leaves or takes up to 5 mm
  EXPECT_TRUE(physics.is_touching());
  EXPECT_NEAR(physics.wheels().odometry().x, 2.0 - 0.25, 0.01);
}

TEST(PlanarPhysics, APersonInTheWayStopsTheRobotAndIsNotPushed) {
  PlanarPhysics physics(small_room(6.0, 4.0), round_robot(), {1.0, 2.0, 0.0}, Rng(1));
  physics.add({.pose = {2.0, 2.0, 1.0}, .radius = 0.3});
  drive(physics, {.forward_velocity = 0.5}, 4.0);
  EXPECT_NEAR(physics.robot().x, 2.0 - 0.3 - 0.25, 0.02);
}

TEST(PlanarPhysics, AShutDoorStopsTheRobotAndAnOpenOneDoesNot) {
  for (const bool open : {false, true}) {
    PlanarPhysics physics(small_room(6.0, 4.0), round_robot(), {1.0, 2.0, 0.0}, Rng(1));
    const Pose2 shut{3.0, 1.5, kPi / 2.0};
    const int door = physics.add({.pose = shut, .length = 1.0, .thickness = 0.04});
    if (open) physics.move(door, {3.0, 1.5, 0.0});
    drive(physics, {.forward_velocity = 0.5}, 6.0);
    if (open) {
      EXPECT_GT(physics.robot().x, 3.5);
    } else {
      EXPECT_NEAR(physics.robot().x, 3.0 - 0.02 - 0.25, 0.02);
    }
  }
}

TEST(PlanarPhysics, ABoxHitsWithItsCorners) {
  Robot robot = round_robot();
  robot.footprint = {.length = 0.5, .width = 0.4};
  PlanarPhysics physics(small_room(6.0, 4.0), robot, {1.0, 0.3, 0.0}, Rng(1));
  drive(physics, {.turn_velocity = 0.5}, 8.0);  // no room to turn: corners are 0.32 m out
  EXPECT_GT(physics.robot().y, 0.3);            // so the wall pushes it away
}

TEST(PlanarPhysics, TheSameDriveGivesTheSameBits) {
  const auto run = [] {
    Robot robot = round_robot();
    robot.drive.surface_spread = 0.2;
    robot.drive.kind = DriveKind::skid_steer;
    robot.drive.wheel_base = 0.3;
    PlanarPhysics physics(small_room(6.0, 4.0), robot, {1.0, 2.0, 0.3}, Rng(9));
    drive(physics, {.forward_velocity = 0.4, .turn_velocity = 0.3}, 5.0);
    return physics.robot();
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace mapbed
