#pragma once

#include "core/config/option.h"

namespace mapbed {

// What the readings are made from, before noise.
enum class OdometrySource : int {
  wheels,  // the wheels' turns in physics, slip included
  truth,   // the robot's true motion
};

// What of a movement has errors of its own.
enum class OdometryErrors : int {
  turns,       // start turn, distance and end turn
  components,  // ahead, sideways and turn: wheels with rollers slip otherwise sideways than ahead
};

// Errors of dead reckoning, as turns: each movement between two readings is a start turn alpha, a
// distance d and an end turn beta (Figure 5.2); each of the three gets a systematic and a random
// error. The random ones are given for one metre driven or one radian turned and grow with the
// square root, so that the error of a drive does not depend on how often odometry is read.
struct OdometryModel {
  OdometrySource source = OdometrySource::wheels;
  OdometryErrors errors = OdometryErrors::turns;
  double rate = 0.0;                  // [Hz] readings of their own; 0: only with each laser sweep
  double start_turn_bias = 0.0;       // [rad/m] added to alpha
  double start_turn_per_meter = 0.0;  // [rad] sigma after one metre
  double distance_bias = 0.0;         // relative error of d
  double distance_per_meter = 0.0;    // [m] sigma after one metre
  double end_turn_bias = 0.0;         // relative error of the whole turn
  double end_turn_per_meter = 0.0;    // [rad] sigma after one metre
  double end_turn_per_radian = 0.0;   // [rad] sigma after turning by one radian
  // With errors by components distance_… are those ahead, end_turn_… those of the turn, and
  // sideways:
  double sideways_bias = 0.0;       // relative error
  double sideways_per_meter = 0.0;  // [m] sigma after one metre sideways
  double translation_sigma = 0.0;   // [m] added to every reading's motion, x and y (Figure 3.10)
  double rotation_sigma = 0.0;      // [rad] added to every reading's turn (Figure 3.10)
};

template <class Visitor>
void visit_fields(OdometryModel& o, Visitor&& visit) {
  visit("source", o.source, {"wheels", "truth"}, "what is measured, before noise");
  visit("errors", o.errors, {"turns", "components"},
        "of start turn, distance and end turn, or of ahead, sideways and turn");
  visit("rate", o.rate, Unit::hertz, between(0.0, 1000.0),
        "own readings per second; 0: with each sweep");
  visit("start_turn_bias", o.start_turn_bias, Unit::radian_per_meter, "systematic start turn");
  visit("start_turn_per_meter", o.start_turn_per_meter, Unit::radian, kNotNegative,
        "sigma of the start turn after one metre");
  visit("distance_bias", o.distance_bias, "relative systematic error of distances");
  visit("distance_per_meter", o.distance_per_meter, Unit::meter, kNotNegative,
        "sigma of the distance after one metre");
  visit("end_turn_bias", o.end_turn_bias, "relative systematic error of turns");
  visit("end_turn_per_meter", o.end_turn_per_meter, Unit::radian, kNotNegative,
        "sigma of the end turn after one metre");
  visit("end_turn_per_radian", o.end_turn_per_radian, Unit::radian, kNotNegative,
        "sigma of the end turn after one radian");
  visit("sideways_bias", o.sideways_bias,
        "relative systematic error of the way sideways, with errors of components");
  visit("sideways_per_meter", o.sideways_per_meter, Unit::meter, kNotNegative,
        "sigma of the way sideways after one metre of it, with errors of components");
  visit("translation_sigma", o.translation_sigma, Unit::meter, kNotNegative,
        "Gaussian noise added to every reading's motion, along x and y");
  visit("rotation_sigma", o.rotation_sigma, Unit::radian, kNotNegative,
        "Gaussian noise added to every reading's turn");
}

}  // namespace mapbed
