#include "bench/faults/missing_beams.h"

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_missing_beams(SensorLog log, const MissingBeamsOptions& options, Rng rng) {
  if (options.fraction <= 0.0 || log.empty()) return {std::move(log)};
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    for (double& range : scan->ranges) {
      if (rng.uniform() < options.fraction) range = 0.0;
    }
  }
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
