#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct ReorderedStampsOptions {
  double fraction = 0.0;
};

template <class Visitor>
void visit_fields(ReorderedStampsOptions& o, Visitor&& visit) {
  visit("fraction", o.fraction, kFraction,
        "of the scans, about, that have the stamp of the one before or after");
}

// Neighbouring scans of a laser have each other's stamps, as where messages overtake one another
// and get their stamps on arrival.
BrokenLog with_reordered_stamps(SensorLog log, const ReorderedStampsOptions& options, Rng rng);

}  // namespace mapbed
