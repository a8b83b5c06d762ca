#pragma once

#include "bench/faults/broken_log.h"
#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct RestartOptions {
  bool enabled = false;
  std::vector<double> at = {};  // [s] since the log's start
};

template <class Visitor>
void visit_fields(RestartOptions& o, Visitor&& visit) {
  visit("enabled", o.enabled, "whether odometry restarts");
  visit("at", o.at, Unit::second, kNotNegative,
        "when, since the log's start; none: at one instant by chance, while the robot moves");
}

// Odometry's counters begin again at zero, on the way.
BrokenLog with_restart(SensorLog log, const RestartOptions& options, Rng rng);

}  // namespace mapbed
