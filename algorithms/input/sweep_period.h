#pragma once

#include <map>
#include <vector>

#include "algorithms/remark.h"
#include "core/config/option.h"
#include "core/log/sensor_log.h"

namespace mapbed {

struct SweepOptions {
  double beam_period = 0.0;  // [s] of logs that do not state it
  bool find_period = true;
};

template <class Visitor>
void visit_fields(SweepOptions& o, Visitor&& visit) {
  visit("beam_period", o.beam_period, Unit::second, between(-1.0, 1.0),
        "from one beam to the next where the log does not state it, negative where the last one "
        "comes first; 0: found by the scans");
  visit("find_period", o.find_period,
        "take beams one after the other where scans of a turning robot fit clearly better so");
}

// What the log does not state of a laser: how long it takes from beam to beam.
struct FoundPeriod {
  double beam_period = 0.0;      // [s]
  double mismatch = 0.0;         // [m] of scans about a turn, with it
  double mismatch_before = 0.0;  // [m] without
};

// By laser: lasers of which the log does not state it, where there is clear evidence that they
// sweep all the time between two stamps. Scans that the robot took while it turned and while it did
// not are then distorted against each other.
std::map<int, FoundPeriod> found_periods(const SensorLog& log);

std::vector<Remark> remarks_on(const std::map<int, FoundPeriod>& periods);

}  // namespace mapbed
