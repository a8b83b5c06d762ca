#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct CarriedAwayOptions {
  double duration = 0.0;        // [s]
  std::vector<double> at = {};  // [s] since the log's start
};

template <class Visitor>
void visit_fields(CarriedAwayOptions& o, Visitor&& visit) {
  visit("duration", o.duration, Unit::second, between(0.0, 1e6),
        "how long the robot is off; 0: it is not");
  visit("at", o.at, Unit::second, kNotNegative,
        "when, since the log's start; none: at one instant by chance, while the robot moves");
}

// The robot is switched off, carried to where it had driven in that time, and goes on with the
// odometry of before.
BrokenLog with_carried_away(SensorLog log, const CarriedAwayOptions& options, Rng rng);

}  // namespace mapbed
