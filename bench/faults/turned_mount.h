#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct TurnedMountOptions {
  double angle = 0.0;  // [rad]
};

template <class Visitor>
void visit_fields(TurnedMountOptions& o, Visitor&& visit) {
  visit("angle", o.angle, Unit::radian, between(-3.2, 3.2),
        "by which every laser's stated heading on the robot is too large");
}

// Lasers do not look where the log says that they do.
BrokenLog with_turned_mount(SensorLog log, const TurnedMountOptions& options, Rng rng);

}  // namespace mapbed
