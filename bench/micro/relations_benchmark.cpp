#include <benchmark/benchmark.h>

#include "bench/metrics/relations.h"

namespace mapbed {
namespace {

// A log's worth: poses every 0.2 s, odometry every 0.1 s, relations between stamps off both.
void BM_RelationsByOdometry(benchmark::State& state) {
  const auto seconds = static_cast<double>(state.range(0));
  Trajectory estimate;
  Trajectory odometry;
  std::vector<Relation> relations;
  for (double t = 0.0; t < seconds; t += 0.1) {
    odometry.push_back({t, {t, 0.01 * t, 0.001 * t}});
    if (odometry.size() % 2 == 1) estimate.push_back(odometry.back());
    relations.push_back({t + 0.03, t + 5.07, {5.0, 0.0, 0.0}});
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(relations_error(estimate, relations, odometry));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(relations.size()));
}
BENCHMARK(BM_RelationsByOdometry)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
