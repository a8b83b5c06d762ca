#include "bench/faults/reordered_stamps.h"

#include <map>
#include <utility>

#include "bench/faults/fault_instants.h"

namespace mapbed {

BrokenLog with_reordered_stamps(SensorLog log, const ReorderedStampsOptions& options, Rng rng) {
  if (options.fraction <= 0.0 || log.empty()) return {std::move(log)};
  const TimeInterval whole = whole_of(log);
  // With probability q a scan that has no partner yet changes with the next one: of all scans
  // 2 q / (1 + q) do.
  const double chance = options.fraction / (2.0 - options.fraction);
  std::map<int, LaserScan*> partners;  // by laser, those that wait for the next one
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    LaserScan*& partner = partners[scan->laser];
    if (partner != nullptr) {
      std::swap(*partner, *scan);
      std::swap(partner->time, scan->time);
      partner = nullptr;
    } else if (rng.uniform() < chance) {
      partner = scan;
    }
  }
  return {std::move(log), {whole}};
}

}  // namespace mapbed
