#include <benchmark/benchmark.h>

#include "algorithms/people/tracking_filter.h"
#include "bench/sources/simulate.h"

namespace mapbed {
namespace {

// 30 s in the museum with 15 people, some of them standing.
const SensorLog& museum() {
  static const SensorLog log = [] {
    SimulationPlan plan;
    plan.world = "museum";
    plan.robot = "pioneer";
    plan.path = "tour_with_one_loop";
    plan.people = 15;
    plan.settings = {parse_setting("recorder.longest=30 s")};
    return run_simulation(plan, 1).log;
  }();
  return log;
}

// A scan in, weights out: alignment, features and tracker together. The items are scans.
template <class Filter>
void BM_People(benchmark::State& state) {
  std::int64_t scans = 0;
  for (auto _ : state) {
    Filter filter({}, Rng(1));
    for (const Measurement& measurement : museum()) {
      if (const auto* reading = std::get_if<Odometry>(&measurement)) filter.add(*reading);
      if (const auto* scan = std::get_if<LaserScan>(&measurement)) {
        benchmark::DoNotOptimize(filter.add(*scan, {}));
        ++scans;
      }
    }
  }
  state.SetItemsProcessed(scans);
}
BENCHMARK(BM_People<PeopleFilter>)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_People<KalmanPeopleFilter>)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
