#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct DriftOptions {
  double turn_per_meter = 0.0;  // [rad/m]
};

template <class Visitor>
void visit_fields(DriftOptions& o, Visitor&& visit) {
  visit("turn_per_meter", o.turn_per_meter, Unit::radian_per_meter, between(-1.6, 1.6),
        "that odometry tells too much for every metre of way; 0: none");
}

// Odometry turns while the robot drives straight: one wheel is larger than the other.
BrokenLog with_drift(SensorLog log, const DriftOptions& options, Rng rng);

}  // namespace mapbed
