#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/geometry/trajectory.h"
#include "core/random.h"

namespace mapbed {

struct SkewedSweepsOptions {
  double duration = 0.0;  // [s]
};

template <class Visitor>
void visit_fields(SkewedSweepsOptions& o, Visitor&& visit) {
  visit("duration", o.duration, Unit::second, between(0.0, 10.0),
        "of a sweep, from its first beam to its last; 0: all beams at once, as they are");
}

// Beams are taken one after the other while the robot moves, and the log does not say so. What a
// later beam would have read is looked up in the scan itself: the nearest beam of that direction,
// less the way towards it; a beam that turns out of what the scan saw fails. How the robot moved is
// told by `truth` or, where it is empty, by odometry.
BrokenLog with_skewed_sweeps(SensorLog log, const Trajectory& truth,
                             const SkewedSweepsOptions& options);

}  // namespace mapbed
