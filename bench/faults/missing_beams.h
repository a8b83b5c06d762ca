#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct MissingBeamsOptions {
  double fraction = 0.0;
};

template <class Visitor>
void visit_fields(MissingBeamsOptions& o, Visitor&& visit) {
  visit("fraction", o.fraction, kFraction, "of the beams that fail, each by chance in every scan");
}

// Beams fail and say nothing, not even that the way was free.
BrokenLog with_missing_beams(SensorLog log, const MissingBeamsOptions& options, Rng rng);

}  // namespace mapbed
