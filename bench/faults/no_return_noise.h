#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct NoReturnNoiseOptions {
  double fraction = 0.0;
  double below = 0.05;  // [m]
};

template <class Visitor>
void visit_fields(NoReturnNoiseOptions& o, Visitor&& visit) {
  visit("fraction", o.fraction, kFraction,
        "of the beams that get no return, each by chance, besides those that hit nothing; 0: none, "
        "and these are told as they are");
  visit("below", o.below, Unit::meter, between(0.001, 10.0),
        "the largest range, up to which beams without return read");
}

// Beams without return read a little less than the largest range, as if something were there.
BrokenLog with_no_return_noise(SensorLog log, const NoReturnNoiseOptions& options, Rng rng);

}  // namespace mapbed
