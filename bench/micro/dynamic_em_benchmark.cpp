#include <benchmark/benchmark.h>

#include "algorithms/dynamic_em/dynamic_em.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "core/data_path.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

// The example log, the same drive so many times in a row.
struct Drive {
  SensorLog log;
  Trajectory path;

  explicit Drive(std::int64_t rounds) {
    const RecordedLog once = open_log(find_data_file("log", "scenarios/logs", "example").string());
    for (std::int64_t round = 0; round < rounds; ++round) {
      for (const Measurement& measurement : once.measurements) {
        const auto* scan = std::get_if<LaserScan>(&measurement);
        if (scan == nullptr) continue;
        log.emplace_back(*scan);
        path.push_back({scan->time, *pose_at(once.true_poses, scan->time)});
      }
    }
  }
};

// Expectations and map of one iteration with its labels, by the options' defaults; the items are
// scans. Time is linear in them.
void BM_EmExpectationsAndMap(benchmark::State& state) {
  const Drive drive(state.range(0));
  const DynamicEmOptions options;
  for (auto _ : state) {
    CauseMap map(drive.log, drive.path,
                 {.p_static = options.p_static, .resolution = options.resolution});
    for (int step = 0; step < options.map_steps; ++step) map.step();
    benchmark::DoNotOptimize(map.marginal_log_likelihood());
    benchmark::DoNotOptimize(map.labels(drive.log, drive.path));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(drive.path.size()));
}
BENCHMARK(BM_EmExpectationsAndMap)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

// The whole method with as many iterations, the scans registered again in all but the first.
void BM_Em(benchmark::State& state) {
  const RecordedLog log = open_log(find_data_file("log", "scenarios/logs", "example").string());
  for (auto _ : state) {
    DynamicEm em({.iterations = static_cast<int>(state.range(0)), .improvement = 0.0},
                 [] { return std::make_unique<IncrementalMatcher>(); });
    for (const Measurement& measurement : log.measurements) em.add(measurement);
    em.finish();
    benchmark::DoNotOptimize(em.estimate());
  }
}
BENCHMARK(BM_Em)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
