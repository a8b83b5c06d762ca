#pragma once

#include <Eigen/Core>

#include "algorithms/motion/pose_prior.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

// Section 5.3, Figure 5.2: a motion is a turn alpha, a way d and a turn beta, and each of the three
// has an error of its own that grows with the motion. Where the robot hardly moves forward, alpha
// is taken as zero and the whole turn as beta. Driving backwards is a negative way, not a turn by
// pi.
//
//   sigma_alpha^2 = turn_noise^2 |alpha| + turn_per_meter^2 d + floor_turn^2,  the same for beta
//   sigma_d^2     = way_per_meter^2 d + way_per_turn^2 (|alpha| + |beta|) + floor_way^2
//
// Variances, not spreads, grow with the length of the motion, so that two halves err as the whole.
struct MotionModelOptions {
  double turn_noise = 0.15;      // [rad] after a turn of 1 rad
  double turn_per_meter = 0.08;  // [rad] after a way of 1 m
  double way_per_meter = 0.10;   // [m] after a way of 1 m
  double way_per_turn = 0.03;    // [m] after a turn of 1 rad
  double floor_turn = 0.005;     // [rad]
  double floor_way = 0.005;      // [m] also sideways
  double turn_bias = 0.0;        // mean error of turns, as a share of them
  double way_bias = 0.0;         // mean error of ways, as a share of them
};

template <class Visitor>
void visit_fields(MotionModelOptions& o, Visitor&& visit) {
  visit("turn_noise", o.turn_noise, Unit::radian, kNotNegative, "spread of a turn after 1 rad");
  visit("turn_per_meter", o.turn_per_meter, Unit::radian, kNotNegative,
        "spread of a turn after 1 m");
  visit("way_per_meter", o.way_per_meter, Unit::meter, kNotNegative, "spread of the way after 1 m");
  visit("way_per_turn", o.way_per_turn, Unit::meter, kNotNegative, "spread of the way after 1 rad");
  visit("floor_turn", o.floor_turn, Unit::radian, kPositive, "spread of a turn at least");
  visit("floor_way", o.floor_way, Unit::meter, kPositive, "spread of the way at least");
  visit("turn_bias", o.turn_bias, between(-0.9, 0.9), "mean error of turns, as a share of them");
  visit("way_bias", o.way_bias, between(-0.9, 0.9), "mean error of ways, as a share of them");
}

// The motion's turn, way and turn.
struct TurnWayTurn {
  double alpha = 0.0;  // [rad]
  double way = 0.0;    // [m] negative: backwards
  double beta = 0.0;   // [rad]
};
TurnWayTurn decomposed(const Pose2& motion);

// A motion that may have happened where `measured` was measured.
Pose2 sampled_motion(const Pose2& measured, const MotionModelOptions& options, Rng& rng);

// The same as a Gaussian about the likeliest motion, from `start`: what proposals and searches use.
PosePrior gaussian_after(const Pose2& start, const Pose2& measured,
                         const MotionModelOptions& options);

}  // namespace mapbed
