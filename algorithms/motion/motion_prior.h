#pragma once

#include "algorithms/motion/pose_prior.h"
#include "core/config/option.h"

namespace mapbed {

// How far a motion may be off. Variances grow with the motion and with time, so that a motion is
// worth the same however many scans it is cut into.
struct MotionSpread {
  double position_per_meter = 0.0;  // [m], sigma of the position after 1 m
  double position_per_turn = 0.0;   // [m] after 1 rad
  double position_per_time = 0.0;   // [m] after 1 s
  double heading_per_meter = 0.0;   // [rad], sigma of the heading after 1 m
  double heading_per_turn = 0.0;    // [rad] after 1 rad
  double heading_per_time = 0.0;    // [rad] after 1 s
};

template <class Visitor>
void visit_fields(MotionSpread& o, Visitor&& visit) {
  visit("position_per_meter", o.position_per_meter, Unit::meter, between(0.0, 100.0),
        "sigma of the position after 1 m; it grows with the root");
  visit("position_per_turn", o.position_per_turn, Unit::meter, between(0.0, 100.0),
        "sigma of the position after a turn of 1 rad");
  visit("position_per_time", o.position_per_time, Unit::meter, between(1e-4, 100.0),
        "sigma of the position after 1 s");
  visit("heading_per_meter", o.heading_per_meter, Unit::radian, between(0.0, 10.0),
        "sigma of the heading after 1 m");
  visit("heading_per_turn", o.heading_per_turn, Unit::radian, between(0.0, 10.0),
        "sigma of the heading after a turn of 1 rad");
  visit("heading_per_time", o.heading_per_time, Unit::radian, between(1e-4, 10.0),
        "sigma of the heading after 1 s");
}

// What the motion between two scans is worth: p(x | u, x') of (2.19) about the predicted pose. With
// odometry it is mostly as good as odometry is, and sometimes the wheels slip; without, the robot
// is taken to go on as before, and may have changed its speed.
struct MotionPriorOptions {
  MotionSpread odometry{.position_per_meter = 0.04,
                        .position_per_turn = 0.04,
                        .position_per_time = 0.01,
                        .heading_per_meter = 0.07,
                        .heading_per_turn = 0.2,
                        .heading_per_time = 0.1};
  MotionSpread slip{.position_per_meter = 0.25,
                    .position_per_turn = 0.1,
                    .position_per_time = 0.07,
                    .heading_per_meter = 0.07,
                    .heading_per_turn = 0.2,
                    .heading_per_time = 0.1};
  double slip_share = 0.1;        // of the motions that are as `slip` says
  double position_sigma = 0.03;   // [m] without odometry, at least
  double heading_sigma = 0.05;    // [rad] without odometry, at least
  double speed_sigma = 0.5;       // [m/s] without odometry: change of speed from scan to scan
  double turn_speed_sigma = 0.5;  // [rad/s] the same of the turning speed
};

template <class Visitor>
void visit_fields(MotionPriorOptions& o, Visitor&& visit) {
  visit("odometry", o.odometry, "errors of odometry as they mostly are");
  visit("slip", o.slip, "errors of odometry where wheels slip");
  visit("slip_share", o.slip_share, between(1e-6, 0.999), "how many motions are of that kind");
  visit("position_sigma", o.position_sigma, Unit::meter, between(1e-4, 100.0),
        "without odometry: sigma of the position at least");
  visit("heading_sigma", o.heading_sigma, Unit::radian, between(1e-4, 10.0),
        "without odometry: sigma of the heading at least");
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, between(1e-4, 100.0),
        "without odometry: change of speed from scan to scan");
  visit("turn_speed_sigma", o.turn_speed_sigma, Unit::radian_per_second, between(1e-4, 100.0),
        "without odometry: change of turning speed from scan to scan");
}

struct MotionVariance {
  double position = 0.0;  // [m^2] along each axis
  double heading = 0.0;   // [rad^2]
};

// Of a motion in `seconds`.
MotionVariance variance_after(const Pose2& motion, double seconds, const MotionSpread& spread);

// After a motion that odometry measured, in `seconds`.
PosePrior predict(const Pose2& map_from_robot, const Pose2& motion, double seconds,
                  const MotionPriorOptions& options);

// After `seconds` without odometry, the robot going on with `motion`.
PosePrior predict_blindly(const Pose2& map_from_robot, const Pose2& motion, double seconds,
                          const MotionPriorOptions& options);

}  // namespace mapbed
