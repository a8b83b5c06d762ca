#include "bench/faults/wrong_geometry.h"

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_wrong_geometry(SensorLog log, const WrongGeometryOptions& options, Rng /*rng*/) {
  if ((options.step == 0.0 && options.first_bearing == 0.0) || log.empty()) {
    return {std::move(log)};
  }
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    scan->bearing_step *= 1.0 + options.step;
    scan->first_bearing += options.first_bearing;
  }
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
