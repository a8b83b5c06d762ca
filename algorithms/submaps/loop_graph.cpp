#include "algorithms/submaps/loop_graph.h"

#include <cstddef>

#include "core/check.h"

namespace mapbed {

GraphOptimizationOptions loop_optimization(LoopStage stage) {
  constexpr double kWidth = 3.0;  // [sigma] of a loop that is off, before it counts less
  GraphOptimizationOptions options;
  options.robust.loss =
      stage == LoopStage::final ? RobustLoss::graduated_truncated : RobustLoss::switchable;
  options.robust.width = kWidth;
  return options;
}

PoseGraph<Pose2> believed(const PoseGraph<Pose2>& graph, const std::vector<double>& weights) {
  constexpr double kBelieved = 0.5;  // weight of a constraint
  CHECK(weights.size() == graph.constraints.size());
  PoseGraph<Pose2> result{.nodes = graph.nodes, .constraints = {}};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] >= kBelieved) result.constraints.push_back(graph.constraints[i]);
  }
  return result;
}

}  // namespace mapbed
