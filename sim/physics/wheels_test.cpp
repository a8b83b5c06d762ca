#include "sim/physics/wheels.h"

#include <cmath>
#include <vector>

#include "core/geometry/angle.h"
#include "core/statistics/moments.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

Robot robot_with(DriveKind kind) {
  Robot robot;
  robot.mass = 20.0;
  robot.footprint.radius = 0.25;
  robot.drive.kind = kind;
  robot.drive.track = 0.4;
  robot.drive.wheel_base = kind == DriveKind::differential ? 0.0 : 0.3;
  return robot;
}

struct Drive {
  Pose2 truth;
  Pose2 odometry;
  Twist2 velocity;
};

// On an endless floor without anything in the way.
Drive driven(Wheels wheels, const DriveCommand& command, double seconds, const Pose2& start = {}) {
  constexpr double dt = 0.01;
  Drive d;
  d.truth = start;
  for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i) {
    wheels.drive(command, dt);
    d.velocity = wheels.push(d.velocity, d.truth, dt);
    d.truth = d.truth * Pose2{d.velocity.forward * dt, d.velocity.left * dt, d.velocity.turn * dt};
  }
  d.odometry = wheels.odometry();
  return d;
}

class EveryDrive : public ::testing::TestWithParam<DriveKind> {};

TEST_P(EveryDrive, ReachesTheSpeedThatItWasTold) {
  const Wheels wheels(robot_with(GetParam()), Rng(1));
  const Drive d = driven(wheels, {.forward_velocity = 0.5, .turn_velocity = 0.4}, 3.0);
  EXPECT_NEAR(d.velocity.forward, 0.5, 0.01);
  EXPECT_NEAR(d.velocity.turn, 0.4, 0.01);
}

TEST_P(EveryDrive, ObeysItsLimits) {
  Robot robot = robot_with(GetParam());
  robot.drive.max_speed = 0.3;
  const Drive d = driven(Wheels(robot, Rng(1)), {.forward_velocity = 9.0}, 3.0);
  EXPECT_NEAR(d.velocity.forward, 0.3, 1e-3);
}

TEST_P(EveryDrive, AgreesWithItsOdometryOnAGoodFloor) {
  const Wheels wheels(robot_with(GetParam()), Rng(1));
  const Drive d = driven(wheels, {.forward_velocity = 0.4, .turn_velocity = 0.3}, 5.0);
  // Slip while speeding up: at most 2 cm/s * a / (mu g) for v / a seconds, far below 1 cm; the
  // regularised slip of turning wheels moves a skid-steered robot's pivot by up to 2 cm.
  EXPECT_THAT(d.odometry, IsNear(d.truth, Tolerance{0.05, 0.03}));
}

INSTANTIATE_TEST_SUITE_P(Wheels, EveryDrive,
                         ::testing::Values(DriveKind::synchro, DriveKind::differential,
                                           DriveKind::skid_steer, DriveKind::omni,
                                           DriveKind::ackermann));

// A fifth of a radian along a circle of 1 m: the chord is 3e-4 m shorter than the arc.
TEST(Wheels, OdometryFollowsTheArcWithinAStep) {
  Wheels wheels(robot_with(DriveKind::differential), Rng(1));
  wheels.drive({.forward_velocity = 0.4, .turn_velocity = 0.4}, 100.0);  // up to speed
  wheels.push({}, {}, 0.5);
  const Pose2 arc{std::sin(0.2), 1.0 - std::cos(0.2), 0.2};
  EXPECT_THAT(wheels.odometry(), IsNear(arc, Tolerance{4e-4, 1e-9}));
}

TEST(Wheels, OneSmallerWheelBendsTheWayButNotTheOdometry) {
  Robot robot = robot_with(DriveKind::differential);
  robot.drive.wheel_spread = 0.05;
  const Drive d = driven(Wheels(robot, Rng(3)), {.forward_velocity = 0.5}, 10.0);
  EXPECT_EQ(d.odometry.theta, 0.0);
  EXPECT_GT(std::abs(d.truth.theta), radians(5.0));
}

// Five standard errors.
void expect_moments(const std::vector<double>& values, double mean, double sigma) {
  const double root = std::sqrt(static_cast<double>(values.size()));
  EXPECT_NEAR(mean_of(values), mean, 5.0 * sigma / root);
  EXPECT_NEAR(sigma_of(values), sigma, 5.0 * sigma / root / std::sqrt(2.0));
}

TEST(Wheels, TheirRadiiHaveTheSigmaThatWasAskedFor) {
  Robot robot = robot_with(DriveKind::differential);
  robot.drive.wheel_spread = 0.01;
  std::vector<double> differences;  // of right and left radius, relative
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Drive d = driven(Wheels(robot, Rng(seed)), {.forward_velocity = 0.5}, 2.0);
    differences.push_back(d.velocity.turn * robot.drive.track / 0.5);
  }
  expect_moments(differences, 0.0, 0.01 * std::sqrt(2.0));
}

TEST(Wheels, SkidSteeringTurnsAsTheFloorsFrictionSays) {
  Robot robot = robot_with(DriveKind::skid_steer);
  robot.drive.surface_spread = 0.15;
  const double a2 = 0.15 * 0.15;  // half the wheel base, squared
  const double b2 = 0.2 * 0.2;    // half the track, squared
  std::vector<double> sideways;
  for (std::uint64_t floor = 0; floor < 300; ++floor) {
    const Pose2 inside_a_patch{1.0, 1.0, 0.0};
    const Drive d = driven(Wheels(robot, Rng(floor)), {.turn_velocity = 0.5}, 2.0, inside_a_patch);
    // The moments balance at omega = w (a^2 + b^2) / (b^2 + k^2 a^2), k being sideways friction
    // over lengthwise; odometry believes in k = 1.
    sideways.push_back(std::sqrt((0.5 / d.velocity.turn * (a2 + b2) - b2) / a2));
  }
  expect_moments(sideways, 1.0, 0.15);
}

TEST(Wheels, ASynchroDriveDoesNotCareAboutSidewaysFriction) {
  Robot robot = robot_with(DriveKind::synchro);
  robot.drive.surface_spread = 0.3;
  const Drive d = driven(Wheels(robot, Rng(5)), {.turn_velocity = 0.5}, 4.0);
  EXPECT_NEAR(angle_difference(d.odometry.theta, d.truth.theta), 0.0, radians(0.5));
}

TEST(Wheels, RollersDriveSidewaysWhileTheBodyTurns) {
  const Wheels wheels(robot_with(DriveKind::omni), Rng(1));
  const Drive straight = driven(wheels, {.left_velocity = 0.4}, 5.0);
  // Speeding up to 0.4 m/s at 0.5 m/s^2 costs 0.16 m; slip less than 1 cm.
  EXPECT_THAT(straight.truth, IsNear(Pose2{0.0, 2.0 - 0.16, 0.0}, Tolerance{0.01, 1e-6}));
  EXPECT_THAT(straight.odometry, IsNear(straight.truth, Tolerance{0.01, 1e-6}));

  const Drive turning =
      driven(wheels, {.forward_velocity = 0.3, .turn_velocity = 0.5, .left_velocity = 0.3}, 5.0);
  EXPECT_NEAR(turning.velocity.left, 0.3, 0.01);
  EXPECT_NEAR(turning.velocity.turn, 0.5, 0.01);
  EXPECT_THAT(turning.odometry, IsNear(turning.truth, Tolerance{0.02, 0.02}));
}

TEST(Wheels, TheLimitOfSpeedHoldsInEveryDirection) {
  const Wheels wheels(robot_with(DriveKind::omni), Rng(1));  // 0.8 m/s
  const Drive d = driven(wheels, {.forward_velocity = 3.0, .left_velocity = 4.0}, 4.0);
  EXPECT_NEAR(d.velocity.forward, 0.8 * 0.6, 1e-3);
  EXPECT_NEAR(d.velocity.left, 0.8 * 0.8, 1e-3);
}

TEST(Wheels, RollersOfOtherRadiiTurnARobotThatDrivesSideways) {
  Robot robot = robot_with(DriveKind::omni);
  robot.drive.wheel_spread = 0.01;
  std::vector<double> turns;  // [rad/m]
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Drive d = driven(Wheels(robot, Rng(seed)), {.left_velocity = 0.4}, 2.0);
    EXPECT_EQ(d.odometry.theta, 0.0);
    turns.push_back(d.velocity.turn / 0.4);
  }
  // Four wheels of v (1 + e) each turn it by +-v e / (4 lever), lever = 0.2 m + 0.15 m.
  expect_moments(turns, 0.0, 0.01 * 2.0 / (4.0 * 0.35));
}

TEST(Wheels, ACarStaysWhereItIsToldToTurnOnTheSpot) {
  const Wheels wheels(robot_with(DriveKind::ackermann), Rng(1));
  const Drive d = driven(wheels, {.turn_velocity = 1.0}, 2.0);
  EXPECT_THAT(d.truth, IsNear(Pose2{}, Tolerance{1e-6, 1e-6}));
}

TEST(Wheels, ACarTurnsOnItsLeastCircleAboutItsRearAxle) {
  Robot robot = robot_with(DriveKind::ackermann);
  robot.drive.max_steering = radians(30.0);
  const double radius = 0.3 / std::tan(radians(30.0));
  EXPECT_NEAR(robot.drive.turning_radius(), radius, 1e-12);
  for (const double direction : {1.0, -1.0}) {
    const double v = direction * 0.3;
    const Drive d = driven(Wheels(robot, Rng(1)), {v, 10.0 * v}, 4.0);
    EXPECT_NEAR(d.velocity.turn, v / radius, 0.01);
    // The middle, half a wheel base ahead of the axle, goes aside.
    EXPECT_NEAR(d.velocity.left, 0.15 * v / radius, 0.005);
    EXPECT_THAT(d.odometry, IsNear(d.truth, Tolerance{0.05, 0.05}));
  }
}

TEST(Wheels, ACarsWheelsAreSteeredNoFasterThanTheyCan) {
  Robot robot = robot_with(DriveKind::ackermann);
  robot.drive.steering_rate = 0.2;
  Wheels wheels(robot, Rng(1));
  for (int i = 0; i < 100; ++i) wheels.drive({.forward_velocity = 0.5, .turn_velocity = 1.0}, 0.01);
  EXPECT_NEAR(wheels.motors().turn_velocity, 0.5 * std::tan(0.2) / 0.3, 1e-9);
  for (int i = 0; i < 300; ++i) wheels.drive({.forward_velocity = 0.5, .turn_velocity = 1.0}, 0.01);
  EXPECT_NEAR(wheels.motors().turn_velocity, 0.5 * std::tan(0.5) / 0.3, 1e-9);  // its largest
}

TEST(Wheels, AMistakenZeroOfTheSteeringBendsTheWayButNotTheOdometry) {
  Robot robot = robot_with(DriveKind::ackermann);
  robot.drive.steering_spread = 0.01;
  std::vector<double> curvatures;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Drive d = driven(Wheels(robot, Rng(seed)), {.forward_velocity = 0.5}, 2.0);
    EXPECT_EQ(d.odometry.theta, 0.0);
    curvatures.push_back(d.velocity.turn / 0.5);
  }
  expect_moments(curvatures, 0.0, 0.01 / 0.3);
}

// A bend of v^2 / R = 4 m/s^2 needs more than the floor gives, mu g = 1 m/s^2.
TEST(Wheels, ACarThatIsTooFastSlidesOutOfItsBend) {
  Robot robot = robot_with(DriveKind::ackermann);
  robot.drive.max_speed = 2.0;
  robot.drive.friction = 0.1;
  const Drive d =
      driven(Wheels(robot, Rng(1)), {.forward_velocity = 2.0, .turn_velocity = 2.0}, 6.0);
  EXPECT_LT(std::abs(d.velocity.turn * d.velocity.forward), 1.2);
}

TEST(Wheels, IceMakesThemSpin) {
  Robot robot = robot_with(DriveKind::differential);
  robot.drive.friction = 0.01;
  robot.drive.acceleration = 2.0;
  const Drive d = driven(Wheels(robot, Rng(1)), {.forward_velocity = 0.8}, 2.0);
  // The floor gives mu g = 0.098 m/s^2: half of that times 4 s^2.
  EXPECT_NEAR(d.truth.x, 0.5 * 0.01 * 9.81 * 4.0, 0.01);
  EXPECT_GT(d.odometry.x, 1.3);
}

}  // namespace
}  // namespace mapbed
