#pragma once

#include "algorithms/localization/laser_weights.h"
#include "algorithms/localization/particle_motion.h"
#include "algorithms/localization/particle_number.h"
#include "algorithms/localization/pose_bins.h"
#include "algorithms/localization/recovery.h"
#include "core/config/option.h"

namespace mapbed {

enum class ParticleMotion : int { odometry, random_step };

struct MonteCarloOptions {
  ParticleNumberOptions particles;
  PoseBinOptions bins;
  double update_distance =
      0.2;                   // [m] of motion between weightings by sensors that repeat themselves
  double update_turn = 0.2;  // [rad] the same
  double update_time = 2.0;  // [s] the same, of a robot that stands, or is carried
  double resample_below = 0.5;  // effective number, as a fraction of the particles
  ParticleMotion motion = ParticleMotion::odometry;
  ParticleErrors odometry;
  RandomStepOptions random_step;
  double start_sigma = 0.3;       // [m] of a start that is told
  double start_turn_sigma = 0.2;  // [rad] the same
  double start_near = 1.0;        // [m] about poses that are told, where the robot begins by them
  bool start_by_sensor = true;
  RecoveryOptions recovery;
  double confidence = 0.95;
  double known_sigma = 0.5;  // [m]
  LaserWeightOptions laser;
};

template <class Visitor>
void visit_fields(MonteCarloOptions& o, Visitor&& visit) {
  visit("particles", o.particles, "how many there are");
  visit("bins", o.bins, "boxes of poses, by which their number and the answer are found");
  visit("update_distance", o.update_distance, Unit::meter, kNotNegative,
        "motion between scans that weight the particles");
  visit("update_turn", o.update_turn, Unit::radian, kNotNegative,
        "turn between scans that weight the particles");
  visit("update_time", o.update_time, Unit::second, kNotNegative,
        "after which a scan weights the particles although odometry says that the robot stands");
  visit("resample_below", o.resample_below, kFraction,
        "effective number of particles, as a fraction, below which they are drawn anew");
  visit("motion", o.motion, {"odometry", "random_step"},
        "how particles move: by odometry, or about where they were, as a person without it");
  visit("odometry_errors", o.odometry.usual, "errors of odometry as they mostly are");
  visit("slip_share", o.odometry.slip_share, kFraction,
        "of the particles, which take a motion for one that slipped");
  visit("slip_factor", o.odometry.slip_factor, between(1.0, 100.0),
        "of the usual sigmas, for those");
  visit("random_step", o.random_step, "where nothing tells the motion");
  visit("start_sigma", o.start_sigma, Unit::meter, between(1e-3, 1000.0),
        "of a start that is told");
  visit("start_turn_sigma", o.start_turn_sigma, Unit::radian, between(1e-3, 10.0),
        "of the heading of such a start");
  visit("start_near", o.start_near, Unit::meter, between(0.01, 1000.0),
        "from a path along which the robot is told to be");
  visit(
      "start_by_sensor", o.start_by_sensor,
      "without a start, particles begin where the first measurement may be from; false: anywhere");
  visit("recovery", o.recovery, "when particles are drawn anew from what sensors say");
  visit("confidence", o.confidence, between(0.5, 0.9999),
        "fraction of the belief that is at one place where the robot's place counts as known");
  visit("known_sigma", o.known_sigma, Unit::meter, between(0.01, 100.0),
        "of the position at most, for that");
  visit("laser", o.laser, "how scans weight the particles");
}

}  // namespace mapbed
