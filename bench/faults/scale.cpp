#include "bench/faults/scale.h"

#include "bench/faults/fault_instants.h"
#include "bench/faults/odometry_steps.h"

namespace mapbed {

BrokenLog with_scale(SensorLog log, const ScaleOptions& options, Rng /*rng*/) {
  if (options.by == 0.0 || log.empty()) return {std::move(log)};
  const double factor = 1.0 + options.by;
  log = with_steps(std::move(log), [factor](const OdometryStep& step) {
    // The same arc, longer: a part of it or beyond its end.
    return interpolate({}, step.motion, factor);
  });
  for (Measurement& measurement : log) {
    auto* reading = std::get_if<Odometry>(&measurement);
    if (reading == nullptr) continue;
    reading->forward_velocity *= factor;
    reading->turn_velocity *= factor;
  }
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
