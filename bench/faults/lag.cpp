#include "bench/faults/lag.h"

#include <algorithm>

#include "bench/faults/fault_instants.h"

namespace mapbed {
namespace {

// By time, odometry before a scan of the same stamp.
bool comes_before(const Measurement& a, const Measurement& b) {
  if (time_of(a) != time_of(b)) return time_of(a) < time_of(b);
  return a.index() < b.index();
}

}  // namespace

BrokenLog with_lag(SensorLog log, const LagOptions& options, Rng /*rng*/) {
  if (options.delay <= 0.0 || log.empty()) return {std::move(log)};
  for (Measurement& measurement : log) {
    if (auto* reading = std::get_if<Odometry>(&measurement)) reading->time += options.delay;
  }
  std::stable_sort(log.begin(), log.end(), comes_before);
  const TimeInterval whole = whole_of(log);
  return {std::move(log), {whole}};
}

}  // namespace mapbed
