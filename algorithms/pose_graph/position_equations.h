#pragma once

#include <vector>

#include "algorithms/pose_graph/free_nodes.h"
#include "algorithms/pose_graph/fronts/block_cholesky.h"

namespace mapbed {

// Given the rotations of a graph's nodes, errors are linear in their positions: the best ones are
// found at once, however far away.
template <class Pose>
class PositionEquations {
 public:
  explicit PositionEquations(const PoseGraph<Pose>& graph);

  // The nodes with their rotations at the positions of least cost; as they are where these are not
  // fixed by the constraints.
  std::vector<Pose> solve(const PoseGraph<Pose>& graph, const std::vector<Pose>& nodes,
                          const std::vector<double>& weights);

 private:
  static constexpr int kSize = kDegreesOfFreedom<Pose> == 3 ? 2 : 3;

  FreeNodes free_;
  BlockCholesky<kSize> matrix_;
};

}  // namespace mapbed
