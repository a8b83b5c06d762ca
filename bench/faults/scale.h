#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct ScaleOptions {
  double by = 0.0;
};

template <class Visitor>
void visit_fields(ScaleOptions& o, Visitor&& visit) {
  visit("by", o.by, between(-0.99, 10.0),
        "of every step, its way and its turn, that odometry tells too much; negative: too little");
}

// Wheels of another size than odometry takes them to have.
BrokenLog with_scale(SensorLog log, const ScaleOptions& options, Rng rng);

}  // namespace mapbed
