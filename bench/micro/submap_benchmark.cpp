#include <variant>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/lazy_association/submap_evidence.h"
#include "algorithms/submaps/node_chain.h"
#include "algorithms/submaps/submap_matcher.h"
#include "core/data_path.h"
#include "core/geometry/angle.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

constexpr double kWindow = 15.0;  // [m] the largest of the method `graph`

// The local maps of the example log, a drive round four rooms on 20 m x 14 m.
struct Pieces {
  NodeChainOptions options;
  std::vector<Submap> submaps;
  std::vector<SubmapField> fields;
  std::vector<Pose2> true_poses;

  Pieces() {
    const RecordedLog log = open_log(find_data_file("log", "scenarios/logs", "example").string());
    NodeChain chain(options);
    std::vector<double> node_times;
    const auto take = [&](std::optional<NodeChain::NewSubmap> ended) {
      if (!ended) return;
      fields.push_back(make_field(ended->submap, options.submaps, kWindow));
      submaps.push_back(std::move(ended->submap));
      const double time = node_times[static_cast<std::size_t>(ended->node)];
      true_poses.push_back(*pose_at(log.true_poses, time));
    };
    for (const Measurement& measurement : log.measurements) {
      std::optional<NodeChain::NewSubmap> ended = chain.add(measurement, {});
      if (const auto* scan = std::get_if<LaserScan>(&measurement)) {
        if (chain.nodes() > node_times.size()) node_times.push_back(scan->time);
      }
      take(std::move(ended));
    }
    take(chain.end());
  }
};

const Pieces& pieces() {
  static const Pieces made;
  return made;
}

// Each of them in each of those before it, within a window [m] and turns [rad] about where it is.
void match_all(benchmark::State& state, double window, double turn_window) {
  for (auto _ : state) {
    for (std::size_t query = 1; query < pieces().submaps.size(); ++query) {
      for (std::size_t target = 0; target < query; ++target) {
        const Pose2 predicted =
            motion_between(pieces().true_poses[target], pieces().true_poses[query]) *
            Pose2{0.3, -0.2, 0.05};
        benchmark::DoNotOptimize(match_submaps(pieces().submaps[target], pieces().fields[target],
                                               pieces().submaps[query], pieces().fields[query],
                                               predicted, window, turn_window, {}));
      }
    }
  }
  const auto count = static_cast<std::int64_t>(pieces().submaps.size());
  state.SetItemsProcessed(state.iterations() * count * (count - 1) / 2);
}

void BM_SubmapMatchNearby(benchmark::State& state) {
  match_all(state, 1.0, 0.3);
}
BENCHMARK(BM_SubmapMatchNearby)->Unit(benchmark::kMillisecond);

void BM_SubmapMatchAnywhere(benchmark::State& state) {
  match_all(state, kWindow, kPi);
}
BENCHMARK(BM_SubmapMatchAnywhere)->Unit(benchmark::kMillisecond);

// Under poses that no earlier comparison was near.
void BM_SubmapEvidence(benchmark::State& state) {
  SubmapEvidence evidence({});
  for (const Submap& submap : pieces().submaps) evidence.add(submap);
  double moved = 0.0;  // [m] of every second one
  for (auto _ : state) {
    moved = moved > 1.0 ? 0.0 : moved + 0.05;
    std::vector<Pose2> poses = pieces().true_poses;
    for (std::size_t i = 1; i < poses.size(); i += 2) poses[i].x += moved;
    benchmark::DoNotOptimize(evidence.log_likelihood(poses));
  }
}
BENCHMARK(BM_SubmapEvidence)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mapbed
