#include "bench/faults/no_return_noise.h"

#include <algorithm>

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_no_return_noise(SensorLog log, const NoReturnNoiseOptions& options, Rng rng) {
  if (options.fraction <= 0.0 || log.empty()) return {std::move(log)};
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    for (std::size_t beam = 0; beam < scan->ranges.size(); ++beam) {
      const bool has_no_return = rng.uniform() < options.fraction || scan->is_max_range(beam);
      if (!has_no_return) continue;
      // In (0, below]: never the largest range itself, which would say that nothing was hit.
      const double less = options.below * (1.0 - rng.uniform());
      scan->ranges[beam] = std::max(0.0, scan->max_range - less);
    }
  }
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
