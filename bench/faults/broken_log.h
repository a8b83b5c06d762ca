#pragma once

#include <vector>

#include "core/log/sensor_log.h"
#include "core/time_interval.h"

namespace mapbed {

// What a fault makes of a log. Faults are pure functions of log, options and, where it matters at
// which instant they strike, a generator. One of no strength (its options' defaults) leaves the log
// as it is, byte for byte.
struct BrokenLog {
  SensorLog log;                        // in order of time, as every log
  std::vector<TimeInterval> when = {};  // the fault was at work; empty: never
};

}  // namespace mapbed
