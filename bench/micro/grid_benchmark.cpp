#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/grid/beam_likelihood.h"
#include "algorithms/grid/counting_map.h"
#include "algorithms/grid/odds_map.h"
#include "algorithms/grid/traversal.h"
#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

// Scans of 180 beams, 5 m long in the mean as in an office, from places along a corridor.
std::vector<Beam> office_beams() {
  Rng rng(1);
  std::vector<Beam> beams;
  for (int scan = 0; scan < 100; ++scan) {
    const Eigen::Vector2d start(0.2 * scan, rng.uniform(-0.5, 0.5));
    for (int n = 0; n < 180; ++n) {
      const double angle = radians(n - 90.0);
      const double range = rng.uniform(1.0, 9.0);
      beams.push_back({start, start + range * Eigen::Vector2d(std::cos(angle), std::sin(angle))});
    }
  }
  return beams;
}

std::int64_t cells_covered(const std::vector<Beam>& beams, const GridFrame& frame) {
  std::int64_t cells = 0;
  for (const Beam& beam : beams) {
    traverse(beam.start, beam.end, frame, [&](CellIndex, double) { ++cells; });
    ++cells;
  }
  return cells;
}

// The items are cells.
void BM_InsertIntoCountingMap(benchmark::State& state) {
  const GridFrame frame{.resolution = 0.05};
  const std::vector<Beam> beams = office_beams();
  CountingMap map(frame);
  for (auto _ : state) {
    for (const Beam& beam : beams) map.insert(beam);
  }
  state.SetItemsProcessed(state.iterations() * cells_covered(beams, frame));
}
BENCHMARK(BM_InsertIntoCountingMap)->Unit(benchmark::kMillisecond);

void BM_InsertIntoOddsMap(benchmark::State& state) {
  const GridFrame frame{.resolution = 0.05};
  const std::vector<Beam> beams = office_beams();
  OddsMap map(frame);
  for (auto _ : state) {
    for (const Beam& beam : beams) map.insert(beam);
  }
  state.SetItemsProcessed(state.iterations() * cells_covered(beams, frame));
}
BENCHMARK(BM_InsertIntoOddsMap)->Unit(benchmark::kMillisecond);

void BM_BeamLikelihood(benchmark::State& state) {
  const GridFrame frame{.resolution = 0.05};
  const std::vector<Beam> beams = office_beams();
  CountingMap map(frame);
  for (const Beam& beam : beams) map.insert(beam);
  const OccupancyMap occupancy = map.occupancy();
  for (auto _ : state) {
    double sum = 0.0;
    for (const Beam& beam : beams) sum += log_likelihood(beam, occupancy);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * cells_covered(beams, frame));
}
BENCHMARK(BM_BeamLikelihood)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
