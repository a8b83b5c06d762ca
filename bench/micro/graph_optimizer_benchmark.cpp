#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/initial_poses.h"

// The files in pose_graphs/ of the folder that MAPBED_DATA names; none where it names none. Beside
// Ceres: pose_graph_ceres.cpp.

namespace mapbed {
namespace {

namespace fs = std::filesystem;

enum class Start { file, spanning_tree, chordal };

AnyPoseGraph graph_of(const std::string& path, Start start, bool& is_there) {
  GraphFile file = load_graph(path);
  is_there = start != Start::file || file.has_poses;
  std::visit(
      [&](auto& graph) {
        if (start == Start::spanning_tree) graph.nodes = spanning_tree_poses(graph);
        if (start == Start::chordal) graph.nodes = chordal_poses(graph);
      },
      file.graph);
  return std::move(file.graph);
}

void optimize_file(benchmark::State& state, const std::string& path, Start start) {
  bool is_there = true;
  const AnyPoseGraph any = graph_of(path, start, is_there);
  if (!is_there) {
    state.SkipWithError("has no poses");
    return;
  }
  std::visit(
      [&](const auto& graph) {
        double chi2 = 0.0;
        int iterations = 0;
        for (auto _ : state) {
          const auto optimum = optimize(graph);
          chi2 = optimum.chi2_after;
          iterations = optimum.iterations;
        }
        state.counters["chi2"] = chi2;
        state.counters["iterations"] = iterations;
      },
      any);
}

void read_file(benchmark::State& state, const std::string& path) {
  for (auto _ : state) benchmark::DoNotOptimize(load_graph(path));
}

void chordal_start(benchmark::State& state, const std::string& path) {
  const GraphFile file = load_graph(path);
  for (auto _ : state) {
    std::visit([](const auto& graph) { benchmark::DoNotOptimize(chordal_poses(graph)); },
               file.graph);
  }
}

std::vector<std::string> graph_paths() {
  const char* const data = std::getenv("MAPBED_DATA");
  const fs::path folder = fs::path(data == nullptr ? "" : data) / "pose_graphs";
  std::vector<std::string> paths;
  if (data == nullptr || !fs::is_directory(folder)) return paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".gz") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

const bool kRegistered = [] {
  for (const std::string& path : graph_paths()) {
    const std::string name = fs::path(path).stem().stem().string();
    const auto add = [&](const std::string& what, auto function) {
      benchmark::RegisterBenchmark(("BM_Graph/" + what + "/" + name).c_str(), function)
          ->Unit(benchmark::kMillisecond);
    };
    add("read", [path](benchmark::State& state) { read_file(state, path); });
    add("chordal_start", [path](benchmark::State& state) { chordal_start(state, path); });
    for (const auto& [start, from] : {std::pair{Start::file, "optimize_from_file"},
                                      {Start::spanning_tree, "optimize_from_spanning_tree"},
                                      {Start::chordal, "optimize_from_chordal"}}) {
      add(from,
          [path, start = start](benchmark::State& state) { optimize_file(state, path, start); });
    }
  }
  return true;
}();

}  // namespace
}  // namespace mapbed
