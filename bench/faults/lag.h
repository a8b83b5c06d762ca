#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct LagOptions {
  double delay = 0.0;  // [s]
};

template <class Visitor>
void visit_fields(LagOptions& o, Visitor&& visit) {
  visit("delay", o.delay, Unit::second, between(0.0, 60.0),
        "by which stamps of odometry are late; 0: none are");
}

// Odometry gets its stamps late: a reading tells where the robot was some time before.
BrokenLog with_lag(SensorLog log, const LagOptions& options, Rng rng);

}  // namespace mapbed
