#include "bench/experiments/false_loops/graph_files.h"

#include <utility>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/initial_poses.h"

namespace mapbed {
namespace {

// From chordal poses, or the file's where these lead to a lower one.
template <class Pose>
KnownGraph<Pose> with_optimum(PoseGraph<Pose> graph, bool has_poses) {
  const GraphOptimum<Pose> of_file = optimize(graph);
  graph.nodes = chordal_poses(graph);
  const GraphOptimum<Pose> of_chordal = optimize(graph);
  const bool is_better = has_poses && of_file.chi2_after < of_chordal.chi2_after;
  KnownGraph<Pose> known{.truth = is_better ? of_file.poses : of_chordal.poses};
  graph.nodes = odometry_poses(graph);
  known.graph = std::move(graph);
  return known;
}

}  // namespace

const AnyKnownGraph& GraphFiles::at(const std::string& path) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = by_path_.find(path);
  if (found != by_path_.end()) return found->second;
  GraphFile file = load_graph(path);
  AnyKnownGraph known = std::visit(
      [&](auto& graph) -> AnyKnownGraph { return with_optimum(std::move(graph), file.has_poses); },
      file.graph);
  return by_path_.emplace(path, std::move(known)).first->second;
}

}  // namespace mapbed
