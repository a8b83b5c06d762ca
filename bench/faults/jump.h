#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct JumpOptions {
  double distance = 0.0;        // [m]
  double turn = 0.0;            // [rad]
  std::vector<double> at = {};  // [s] since the log's start
};

template <class Visitor>
void visit_fields(JumpOptions& o, Visitor&& visit) {
  visit("distance", o.distance, Unit::meter, kNotNegative, "that is told too much, to any side");
  visit("turn", o.turn, Unit::radian, between(-6.3, 6.3), "that is told too much");
  visit("at", o.at, Unit::second, kNotNegative,
        "when, since the log's start; none: at one instant by chance, while the robot moves");
}

// Odometry jumps from one reading to the next and goes on from there.
BrokenLog with_jump(SensorLog log, const JumpOptions& options, Rng rng);

}  // namespace mapbed
