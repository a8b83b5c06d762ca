#include "bench/faults/stall.h"

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_stall(SensorLog log, const StallOptions& options, Rng rng) {
  if (options.duration <= 0.0) return {std::move(log)};
  BrokenLog broken{std::move(log)};
  for (const double from : fault_instants(broken.log, options.at, options.duration, rng)) {
    const Odometry* held = nullptr;
    bool is_stalled = false;  // not where readings are further apart than the stall is long
    for (Measurement& measurement : broken.log) {
      auto* reading = std::get_if<Odometry>(&measurement);
      if (reading == nullptr) continue;
      if (reading->time <= from || held == nullptr) {
        held = reading;
      } else if (reading->time < from + options.duration) {
        reading->odometry_from_robot = held->odometry_from_robot;
        reading->forward_velocity = 0.0;
        reading->turn_velocity = 0.0;
        is_stalled = true;
      }
    }
    if (is_stalled) broken.when.push_back({from, from + options.duration});
  }
  return broken;
}

}  // namespace mapbed
