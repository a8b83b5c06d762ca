#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct DroppedScansOptions {
  double fraction = 0.0;
};

template <class Visitor>
void visit_fields(DroppedScansOptions& o, Visitor&& visit) {
  visit("fraction", o.fraction, kFraction, "of the scans that are lost, each by chance");
}

// Scans are lost on their way into the log; the first one is not.
BrokenLog with_dropped_scans(SensorLog log, const DroppedScansOptions& options, Rng rng);

}  // namespace mapbed
