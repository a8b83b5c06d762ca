#include <cmath>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/rfid/rfid_weights.h"
#include "algorithms/rfid/tag_mapper.h"

namespace mapbed {
namespace {

// A robot that goes round in a square corridor of 20 m a side and hears a tag in each round.
struct HeardRound {
  RfidDetections round;
  Pose2 map_from_robot;
};

std::vector<HeardRound> heard_rounds(int count) {
  std::vector<HeardRound> rounds;
  for (int i = 0; i < count; ++i) {
    const double way = std::fmod(0.02 * i, 80.0);
    const int side = static_cast<int>(way / 20.0);
    Pose2 corner;
    for (int s = 0; s < side; ++s) corner = corner * Pose2{20.0, 0.0, 0.5 * kPi};
    HeardRound heard;
    heard.map_from_robot = corner * Pose2{way - 20.0 * side, 0.0, 0.0};
    heard.round.time = 0.1 * i;
    heard.round.antenna = i % 2;
    heard.round.robot_from_antenna.planar = {0.1, 0.1, i % 2 == 0 ? 0.8 : -0.8};
    heard.round.reads = {{"tag_" + std::to_string(static_cast<int>(way / 0.8)), -50.0}};
    rounds.push_back(heard);
  }
  return rounds;
}

const LearnedRfid kTwo{SmoothAntenna{}, SmoothAntenna{}};

// 50,000 detections with 1000 positions a tag. The items are detections.
void BM_MapTags(benchmark::State& state) {
  const std::vector<HeardRound> rounds = heard_rounds(50'000);
  for (auto _ : state) {
    TagMapper mapper(kTwo, {.positions = 1000}, Rng(1));
    for (const HeardRound& heard : rounds) mapper.add(heard.round, heard.map_from_robot);
    benchmark::DoNotOptimize(mapper.beliefs());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rounds.size()));
}
BENCHMARK(BM_MapTags)->Unit(benchmark::kMillisecond);

// A round with three answers among a hundred tags. The items are particles.
void BM_WeighByTags(benchmark::State& state) {
  OccupancyMap map(GridFrame{.resolution = 0.1});
  for (int y = -200; y < 200; ++y) {
    for (int x = -200; x < 200; ++x) map.at({x, y}) = known(0.1);
  }
  std::vector<TagBelief> tags;
  for (int i = 0; i < 100; ++i) {
    tags.push_back(
        {"tag_" + std::to_string(i), {{-18.0 + 4.0 * (i % 10), -18.0 + 4.0 * (i / 10)}}, {1.0}});
  }
  RfidWeights weights(0, kTwo[0], tags, map, {});
  RfidDetections round;
  round.reads = {{"tag_44"}, {"tag_45"}, {"tag_54"}};
  weights.take(round, {});
  Rng rng(2);
  std::vector<Pose2> particles;
  for (int i = 0; i < 100'000; ++i) {
    particles.push_back(
        {rng.uniform(-19.0, 19.0), rng.uniform(-19.0, 19.0), rng.uniform(-kPi, kPi)});
  }
  std::vector<double> log_weights(particles.size());
  for (auto _ : state) {
    weights.add_log_weights(particles, log_weights);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(particles.size()));
}
BENCHMARK(BM_WeighByTags)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mapbed
