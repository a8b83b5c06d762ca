#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct StallOptions {
  double duration = 0.0;        // [s]
  std::vector<double> at = {};  // [s] since the log's start
};

template <class Visitor>
void visit_fields(StallOptions& o, Visitor&& visit) {
  visit("duration", o.duration, Unit::second, between(0.0, 3600.0), "how long; 0: no stall");
  visit("at", o.at, Unit::second, kNotNegative,
        "when, since the log's start; none: at one instant by chance, while the robot moves");
}

// Odometry stands still and then catches up: after the stall it tells in one step what it had not.
BrokenLog with_stall(SensorLog log, const StallOptions& options, Rng rng);

}  // namespace mapbed
