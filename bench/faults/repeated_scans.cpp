#include "bench/faults/repeated_scans.h"

#include <map>

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_repeated_scans(SensorLog log, const RepeatedScansOptions& options, Rng rng) {
  if (options.duration <= 0.0) return {std::move(log)};
  BrokenLog broken{std::move(log)};
  for (const double from : fault_instants(broken.log, options.at, options.duration, rng)) {
    bool is_repeated = false;       // not where scans are further apart than that
    std::map<int, LaserScan> last;  // by laser
    for (Measurement& measurement : broken.log) {
      auto* scan = std::get_if<LaserScan>(&measurement);
      if (scan == nullptr || scan->time >= from + options.duration) continue;
      const auto told = last.find(scan->laser);
      if (scan->time <= from || told == last.end()) {
        last[scan->laser] = *scan;
      } else {
        const double time = scan->time;
        *scan = told->second;
        scan->time = time;
        is_repeated = true;
      }
    }
    if (is_repeated) broken.when.push_back({from, from + options.duration});
  }
  return broken;
}

}  // namespace mapbed
