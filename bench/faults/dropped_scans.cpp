#include "bench/faults/dropped_scans.h"

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_dropped_scans(SensorLog log, const DroppedScansOptions& options, Rng rng) {
  if (options.fraction <= 0.0 || log.empty()) return {std::move(log)};
  const TimeInterval whole = whole_of(log);
  bool is_first = true;
  std::erase_if(log, [&](const Measurement& measurement) {
    if (!std::holds_alternative<LaserScan>(measurement)) return false;
    const bool is_lost = rng.uniform() < options.fraction && !is_first;
    is_first = false;
    return is_lost;
  });
  return {std::move(log), {whole}};
}

}  // namespace mapbed
