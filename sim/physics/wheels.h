#pragma once

#include <array>
#include <functional>

#include "core/driver.h"
#include "core/geometry/pose2.h"
#include "core/random.h"
#include "robots/robot.h"

namespace mapbed {

// Velocity of a body in its own frame.
struct Twist2 {
  double forward = 0.0;  // [m/s]
  double left = 0.0;     // [m/s]
  double turn = 0.0;     // [rad/s]
};

// How wheels and floor move a robot. Each wheel that grips has a contact point p with a surface
// velocity u given by the motor; with the slip s = v + omega x p - u, both in the body frame, the
// floor pushes with Coulomb friction, regularised below a slip of 2 cm/s:
//
//   F = -mu N K K s / max(|K s|, 2 cm/s),    K = diag(1, sideways)
//
// A synchro drive steers its wheels so that a turn needs no slip. Skid steering drags its wheels
// sideways: with half track b and half wheel base a, the moments balance at
// omega = u b / (a^2 + b^2), as if the track were 2 (a^2 + b^2) / b; that is what its odometry
// believes. `sideways` differs from one patch of floor to the next.
//
// Wheels with rollers (omni) and a car's (ackermann) have surface velocities that go together:
// those of one motion of the whole body, which the motors and the steering make. A car turns about
// a point on the line of its rear axle, by v tan(steering) / wheel base; its front wheels are
// steered as far and as fast as they can be.
class Wheels {
 public:
  // `rng` draws the wheels' radii and the floor.
  Wheels(const Robot& robot, const Rng& rng);

  // Speeds that the motors reach after `dt` [s], obeying limits and acceleration.
  void drive(const DriveCommand& command, double dt);

  // The body's velocity `dt` later, and odometry moved on.
  Twist2 push(const Twist2& body, const Pose2& world_from_robot, double dt);

  const Pose2& odometry() const { return odometry_; }  // by the encoders, from the identity
  const DriveCommand& motors() const { return motors_; }

 private:
  struct Contact {
    double x, y;          // [m] in the body frame
    double radius_error;  // relative
  };
  void drive_sideways(const DriveCommand& command, double dt);
  void steer(const DriveCommand& command, double dt);
  Twist2 rolled_by_rollers() const;
  Twist2 rolled_by_car() const;
  Eigen::Vector2d surface_velocity(const Contact& p) const;
  double sideways_friction(const Pose2& world_from_robot) const;
  Twist2 acceleration(const Twist2& body, double sideways) const;

  DriveModel model_;
  double inertia_per_mass_;  // [m^2]
  double believed_track_;    // [m]
  Rng floor_;
  std::array<Contact, 4> contacts_{};
  std::size_t contact_count_ = 0;
  double steering_ = 0.0;       // [rad] as the car believes
  double steering_zero_ = 0.0;  // [rad] by which it is mistaken
  Twist2 rolled_;               // of omni and ackermann: what the wheels make of the body's motion
  DriveCommand motors_;
  Pose2 odometry_;
};

// About the centre of the footprint. [m^2]
double inertia_per_mass(const RobotFootprint& footprint);

}  // namespace mapbed
