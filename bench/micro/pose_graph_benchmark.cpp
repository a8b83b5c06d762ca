#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Cholesky>
#include <benchmark/benchmark.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/incremental_graph.h"
#include "core/statistics/quantile.h"

namespace mapbed {
namespace {

// Manhattan at its optimum, from the folder that MAPBED_DATA names; without nodes where it is not
// there.
const PoseGraph<Pose2>& manhattan() {
  static const PoseGraph<Pose2> graph = [] {
    const char* const data = std::getenv("MAPBED_DATA");
    const auto path =
        std::filesystem::path(data == nullptr ? "" : data) / "pose_graphs" / "manhattan.g2o.gz";
    if (!std::filesystem::exists(path)) return PoseGraph<Pose2>{};
    auto read = std::get<PoseGraph<Pose2>>(load_graph(path.string()).graph);
    for (const PoseConstraint<Pose2>& c : read.constraints) {
      if (c.closes_loop) continue;
      read.nodes[static_cast<std::size_t>(c.to)] =
          read.nodes[static_cast<std::size_t>(c.from)] * c.from_from_to;
    }
    read.nodes = optimize(read).poses;
    return read;
  }();
  return graph;
}

// The factor of its information matrix at the optimum, and the loop constraints in it.
struct Factor {
  SparseFactor<3> factor{0, {}};
  std::vector<NodeRows<3>> loops;

  Factor() {
    std::vector<NodeBlock<3>> blocks = {{0, 0, Eigen::Matrix3d::Identity() * 1e4}};
    for (const PoseConstraint<Pose2>& c : manhattan().constraints) {
      const LinearError<Pose2> linear =
          linear_error(c.from_from_to, manhattan().nodes[static_cast<std::size_t>(c.from)],
                       manhattan().nodes[static_cast<std::size_t>(c.to)]);
      const Eigen::Matrix3d root = c.information.llt().matrixU();
      const NodeRows<3> rows{c.from, c.to, root * linear.by_from, root * linear.by_to,
                             -root * linear.error};
      blocks.push_back({c.from, c.from, rows.of_first.transpose() * rows.of_first});
      blocks.push_back({c.from, c.to, rows.of_first.transpose() * rows.of_second});
      blocks.push_back({c.to, c.to, rows.of_second.transpose() * rows.of_second});
      if (c.closes_loop) loops.push_back(rows);
    }
    factor = SparseFactor<3>(static_cast<int>(manhattan().nodes.size()), blocks);
    factor.factorize(blocks);
  }
};

bool is_missing(benchmark::State& state) {
  if (!manhattan().nodes.empty()) return false;
  state.SkipWithError("set MAPBED_DATA to a folder that holds pose_graphs/manhattan.g2o.gz");
  return true;
}

// Times of the processor for what is done once for each loop constraint, and their quantiles, which
// other programs on the machine do not change.
class Times {
 public:
  template <class Function>
  void add(benchmark::State& state, const Function& function) {
    const std::clock_t start = std::clock();
    function();
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    state.SetIterationTime(seconds);
    milliseconds_.push_back(1e3 * seconds);
  }

  void tell(benchmark::State& state) const {
    state.counters["median_ms"] = quantile_of(milliseconds_, 0.5);
    state.counters["p95_ms"] = quantile_of(milliseconds_, 0.95);
  }

 private:
  std::vector<double> milliseconds_;
};

enum class Part { addition, removal, solution };

// A loop constraint of Manhattan, in turn all of them, taken out of the factor and added again; or
// all poses from the factor in between.
template <Part part>
void BM_Factor(benchmark::State& state) {
  if (is_missing(state)) return;
  Factor f;
  Times times;
  std::size_t next = 0;
  for (auto _ : state) {
    const NodeRows<3>& loop = f.loops[next++ % f.loops.size()];
    if (part != Part::removal) f.factor.remove(loop);
    times.add(state, [&] {
      if (part == Part::addition) f.factor.add(loop);
      if (part == Part::removal) f.factor.remove(loop);
      if (part == Part::solution) benchmark::DoNotOptimize(f.factor.minimizer());
    });
    if (part != Part::addition) f.factor.add(loop);
  }
  times.tell(state);
}
BENCHMARK(BM_Factor<Part::addition>)->Iterations(1954)->UseManualTime();
BENCHMARK(BM_Factor<Part::removal>)->Iterations(1954)->UseManualTime();
BENCHMARK(BM_Factor<Part::solution>)->Iterations(1954)->UseManualTime();

// The same of the graph, all poses found and nothing linearised anew.
template <Part part>
void BM_IncrementalGraph(benchmark::State& state) {
  if (is_missing(state)) return;
  IncrementalGraph<Pose2> graph(manhattan(), {.max_move = 1e9, .max_turn = 1e9});
  std::vector<std::pair<int, PoseConstraint<Pose2>>> loops;
  for (std::size_t i = 0; i < manhattan().constraints.size(); ++i) {
    const PoseConstraint<Pose2>& c = manhattan().constraints[i];
    if (c.closes_loop) loops.emplace_back(static_cast<int>(i), c);
  }
  Times times;
  std::size_t next = 0;
  for (auto _ : state) {
    auto& [number, loop] = loops[next++ % loops.size()];
    if (part == Part::addition) {
      graph.remove(number);
      times.add(state, [&] { number = graph.add(loop); });
    } else {
      times.add(state, [&] { graph.remove(number); });
      number = graph.add(loop);
    }
  }
  times.tell(state);
}
BENCHMARK(BM_IncrementalGraph<Part::addition>)->Iterations(1954)->UseManualTime();
BENCHMARK(BM_IncrementalGraph<Part::removal>)->Iterations(1954)->UseManualTime();

// What a search over associations pays for a branch: a chain of 200 nodes with a loop at every
// third.
void BM_IncrementalGraphCopy(benchmark::State& state) {
  IncrementalGraph<Pose2> graph(Pose2{});
  for (int i = 0; i < 199; ++i) graph.add_node({i, i + 1, {5.0, 0.0, 0.1}});
  for (int i = 0; i + 63 < 200; i += 3) {
    graph.add({i, i + 63,
               motion_between(graph.poses()[static_cast<std::size_t>(i)],
                              graph.poses()[static_cast<std::size_t>(i + 63)])});
  }
  for (auto _ : state) {
    IncrementalGraph<Pose2> copy = graph;
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(BM_IncrementalGraphCopy)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mapbed
