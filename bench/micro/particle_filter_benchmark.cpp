#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/rbpf/grid_slam.h"
#include "bench/process/thread_limit.h"
#include "core/data_path.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

// The example log, and a particle's map of its true poses.
struct SourceLocation {
  RecordedLog log;
  GridSlamOptions options;
  std::vector<Pose2> poses;
  std::vector<ScanForWeighting> scans;
  SurfaceMap map;

  SourceLocation()
      : log(open_log(find_data_file("log", "scenarios/logs", "example").string())),
        map(options.map_resolution) {
    for (const Measurement& measurement : log.measurements) {
      const auto* scan = std::get_if<LaserScan>(&measurement);
      if (scan == nullptr) continue;
      poses.push_back(*pose_at(log.true_poses, scan->time));
      scans.push_back(
          scan_for_weighting(*scan, options.points, options.likelihood, options.map_resolution));
      map.add(scans.back().surface, poses.back());
    }
  }
};

const SourceLocation& place() {
  static const SourceLocation made;
  return made;
}

// The items are points.
void BM_SurfaceLikelihood(benchmark::State& state) {
  const SurfaceLikelihood likelihood;
  const ScanForWeighting& scan = place().scans[100];
  for (auto _ : state) {
    benchmark::DoNotOptimize(likelihood.log_likelihood(scan, place().map, place().poses[100]));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(scan.hits.size()));
}
BENCHMARK(BM_SurfaceLikelihood);

// What each particle does at an update, from a start 5 cm and 1 degree off.
void BM_LocalPosterior(benchmark::State& state) {
  const SurfaceLikelihood likelihood;
  const Pose2 start = place().poses[100] * Pose2{0.04, -0.03, 0.017};
  const PosePrior prior = independent_prior(start, 0.1, 0.1, 0.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        likelihood.local_posterior(start, place().scans[100], place().map, prior));
  }
}
BENCHMARK(BM_LocalPosterior);

// The items are points.
void BM_SurfaceMapAdd(benchmark::State& state) {
  SurfaceMap map = place().map;
  const std::vector<SurfacePoint>& points = place().scans[100].surface;
  for (auto _ : state) map.add(points, place().poses[100]);
  state.SetItemsProcessed(state.iterations() * static_cast<long>(points.size()));
}
BENCHMARK(BM_SurfaceMapAdd);

// What a resampled particle costs: its share of the map, and the tiles it then writes to.
void BM_SurfaceMapCopyAndAdd(benchmark::State& state) {
  const std::vector<SurfacePoint>& points = place().scans[100].surface;
  for (auto _ : state) {
    SurfaceMap copy = place().map;
    copy.add(points, place().poses[100]);
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(BM_SurfaceMapCopyAndAdd);

// The filter with 100 particles on one core, after so many percent of the log: the time an update
// takes does not grow.
void BM_GridSlam(benchmark::State& state) {
  const ThreadLimit one(1);
  const std::size_t end =
      place().log.measurements.size() * static_cast<std::size_t>(state.range(0)) / 100;
  std::size_t updates = 0;
  for (auto _ : state) {
    GridSlam slam(place().options, Rng(1));
    for (std::size_t i = 0; i < end; ++i) slam.add(place().log.measurements[i]);
    updates += slam.hypotheses().diversity.size();
  }
  state.counters["updates/s"] =
      benchmark::Counter(static_cast<double>(updates), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_GridSlam)->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
