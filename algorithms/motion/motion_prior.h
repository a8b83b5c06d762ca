#pragma once

#include "algorithms/motion/pose_prior.h"
#include "core/config/option.h"

namespace mapbed {

// What the motion between two scans is worth: p(x | u, x') of (2.19) as a Gaussian about the
// predicted pose. With odometry the sigma grows with the motion; without, with the time passed:
// the robot is taken to go on as before, and may have changed its speed.
struct MotionPriorOptions {
  double position_sigma = 0.03;     // [m] at least
  double heading_sigma = 0.05;      // [rad] at least
  double position_per_meter = 0.3;  // [m/m]
  double position_per_turn = 0.05;  // [m/rad]
  double heading_per_meter = 0.1;   // [rad/m]
  double heading_per_turn = 0.3;    // [rad/rad]
  double speed_sigma = 0.5;         // [m/s] without odometry: change of speed from scan to scan
  double turn_speed_sigma = 0.5;    // [rad/s] the same of the turning speed
};

template <class Visitor>
void visit_fields(MotionPriorOptions& o, Visitor&& visit) {
  visit("position_sigma", o.position_sigma, Unit::meter, between(1e-4, 100.0),
        "sigma of the position at least");
  visit("heading_sigma", o.heading_sigma, Unit::radian, between(1e-4, 10.0),
        "sigma of the heading at least");
  visit("position_per_meter", o.position_per_meter, between(0.0, 100.0),
        "sigma of the position, for each metre");
  visit("position_per_turn", o.position_per_turn, between(0.0, 100.0),
        "sigma of the position [m] for each radian");
  visit("heading_per_meter", o.heading_per_meter, Unit::radian_per_meter, between(0.0, 100.0),
        "sigma of the heading for each metre");
  visit("heading_per_turn", o.heading_per_turn, between(0.0, 100.0),
        "sigma of the heading for each radian");
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, between(1e-4, 100.0),
        "without odometry: change of speed from scan to scan");
  visit("turn_speed_sigma", o.turn_speed_sigma, Unit::radian_per_second, between(1e-4, 100.0),
        "without odometry: change of turning speed from scan to scan");
}

// After a motion that odometry measured.
PosePrior predict(const Pose2& map_from_robot, const Pose2& motion,
                  const MotionPriorOptions& options);

// After `seconds` without odometry, the robot going on with `motion`.
PosePrior predict_blindly(const Pose2& map_from_robot, const Pose2& motion, double seconds,
                          const MotionPriorOptions& options);

}  // namespace mapbed
