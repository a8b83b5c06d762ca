#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/grid/wall_map.h"
#include "algorithms/localization/free_space.h"
#include "algorithms/localization/laser_weights.h"
#include "algorithms/localization/particle_motion.h"
#include "algorithms/localization/pose_answer.h"
#include "bench/process/thread_limit.h"
#include "core/data_path.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

constexpr std::size_t kParticles = 100'000;

// Particles anywhere on the map of the example log, and one of its scans with all 180 beams.
struct Weighting {
  LaserScan scan;
  std::vector<Pose2> particles;
  std::vector<double> log_weights;
  std::unique_ptr<LaserWeights> weights;

  Weighting() : log_weights(kParticles) {
    const RecordedLog log = open_log(find_data_file("log", "scenarios/logs", "example").string());
    for (const Measurement& measurement : log.measurements) {
      if (const auto* one = std::get_if<LaserScan>(&measurement)) scan = *one;
    }
    const FreeSpace space(
        std::make_shared<OccupancyMap>(wall_map(log.measurements, log.true_poses)));
    LaserWeightOptions options;
    options.points = {.max_range = 30.0, .min_spacing = 0.0, .max_points = 180};
    weights = std::make_unique<LaserWeights>(options, space, Rng(1));
    Rng rng(2);
    for (std::size_t i = 0; i < kParticles; ++i) particles.push_back(space.sample(rng));
  }
};

// The items are look-ups of beams.
void BM_WeighParticles(benchmark::State& state) {
  const ThreadLimit one(1);
  Weighting weighting;
  weighting.weights->take(weighting.scan, {});
  for (auto _ : state) {
    weighting.weights->add_log_weights(weighting.particles, weighting.log_weights);
    benchmark::ClobberMemory();
  }
  std::int64_t beams = 0;
  for (std::size_t k = 0; k < weighting.scan.ranges.size(); ++k) {
    beams += weighting.scan.is_hit(k) ? 1 : 0;
  }
  state.SetItemsProcessed(beams * state.iterations() * static_cast<std::int64_t>(kParticles));
}
BENCHMARK(BM_WeighParticles)->Unit(benchmark::kMillisecond);

// The items are particles.
void BM_MoveParticles(benchmark::State& state) {
  const ThreadLimit one(1);
  Weighting weighting;
  for (auto _ : state) {
    move_particles(weighting.particles, {0.2, 0.01, 0.05}, ParticleErrors{}, Rng(1));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kParticles));
}
BENCHMARK(BM_MoveParticles)->Unit(benchmark::kMillisecond);

void BM_AnswerOfParticles(benchmark::State& state) {
  const Weighting weighting;
  const std::vector<double> weights(kParticles, 1.0 / static_cast<double>(kParticles));
  for (auto _ : state) {
    benchmark::DoNotOptimize(answer_of(weighting.particles, weights, {}));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kParticles));
}
BENCHMARK(BM_AnswerOfParticles)->Unit(benchmark::kMillisecond);

// All that a scan costs beside its particles: how well it fits elsewhere on the map.
void BM_TakeScan(benchmark::State& state) {
  const ThreadLimit one(1);
  Weighting weighting;
  for (auto _ : state) benchmark::DoNotOptimize(weighting.weights->take(weighting.scan, {}));
}
BENCHMARK(BM_TakeScan)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
