#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct MissedTurnOptions {
  double turn = 0.0;            // [rad]
  std::vector<double> at = {};  // [s] since the log's start
};

template <class Visitor>
void visit_fields(MissedTurnOptions& o, Visitor&& visit) {
  visit("turn", o.turn, Unit::radian, between(0.0, 6.3), "that is missed; 0: none is");
  visit("at", o.at, Unit::second, kNotNegative,
        "when, since the log's start; none: by chance in a turn of that size, within 10 s, or in "
        "the largest one");
}

// The robot turns, and its odometry does not tell: wheels slip, or somebody turns it. From the
// instant on all turning is missed until that much is missing.
BrokenLog with_missed_turn(SensorLog log, const MissedTurnOptions& options, Rng rng);

}  // namespace mapbed
