#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct RepeatedScansOptions {
  double duration = 0.0;        // [s]
  std::vector<double> at = {};  // [s] since the log's start
};

template <class Visitor>
void visit_fields(RepeatedScansOptions& o, Visitor&& visit) {
  visit("duration", o.duration, Unit::second, between(0.0, 3600.0), "how long; 0: not at all");
  visit("at", o.at, Unit::second, kNotNegative,
        "when, since the log's start; none: at one instant by chance, while the robot moves");
}

// Each laser tells its last scan again and again, byte for byte, with stamps that go on.
BrokenLog with_repeated_scans(SensorLog log, const RepeatedScansOptions& options, Rng rng);

}  // namespace mapbed
