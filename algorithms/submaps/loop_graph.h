#pragma once

#include <vector>

#include "algorithms/pose_graph/graph_optimizer.h"

namespace mapbed {

// How a graph whose loops may be wrong is optimised: while the log goes on by switchable
// constraints, in the end by graduated non-convexity.
enum class LoopStage : int { online, final };
GraphOptimizationOptions loop_optimization(LoopStage stage);

// The same graph with the constraints alone that are believed at these weights.
PoseGraph<Pose2> believed(const PoseGraph<Pose2>& graph, const std::vector<double>& weights);

}  // namespace mapbed
