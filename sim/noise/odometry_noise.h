#pragma once

#include "core/random.h"
#include "core/sensor/odometry.h"
#include "robots/odometry_model.h"
#include "sim/sensors/ideal_odometry.h"

namespace mapbed {

// What odometry reads, from the identity on. The motion from reading to reading, taken from wheels
// or truth, is a turn alpha, a straight way d and a turn beta (Figure 5.2); with
// turned = |alpha + beta|:
//   alpha' = alpha + start_turn_bias d + N(0, start_turn_per_meter^2 |d|)
//   d'     = d (1 + distance_bias)     + N(0, distance_per_meter^2 |d|)
//   beta'  = beta + end_turn_bias (alpha + beta)
//                 + N(0, end_turn_per_meter^2 |d| + end_turn_per_radian^2 turned)
// or, with errors of components, of the way (x, y) and the turn:
//   x' = x (1 + distance_bias) + N(0, distance_per_meter^2 |x|), y' likewise by sideways_...
//   turned' = turned (1 + end_turn_bias) + N(0, end_turn_per_meter^2 |d| + end_turn_per_radian^2
//   |turned|)
// then N(0, translation_sigma^2) on x and y and N(0, rotation_sigma^2) on the turn (Figure 3.10).
// d is negative where the robot backs up, so that alpha stays small.
//
// Reading k draws from the stream ("odometry", k).
class OdometryReader {
 public:
  OdometryReader(const OdometryModel& model, const Rng& rng) : model_(model), rng_(rng) {}
  Odometry read(const IdealOdometry& ideal);  // in order of time

 private:
  OdometryModel model_;
  Rng rng_;
  IdealOdometry last_;
  Pose2 pose_;
  std::uint64_t count_ = 0;
};

}  // namespace mapbed
