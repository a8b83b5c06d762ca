#pragma once

#include <vector>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/fronts/block_cholesky.h"

namespace mapbed {

struct FreeNodes;

// The normal equations of a graph, H step = -gradient with H = sum of J' w information J, over the
// nodes that are not held. Vectors hold the nodes' steps in the order of elimination: that of node
// n begins at offset_of(n).
template <class Pose>
class NormalEquations {
 public:
  explicit NormalEquations(const PoseGraph<Pose>& graph);

  int size() const { return matrix_.size(); }  // of vectors
  int offset_of(int node) const;               // -1 of a node that is held

  // `graph` with the constraints that this was made of, `weights` one for each.
  void linearize(const PoseGraph<Pose>& graph, const std::vector<Pose>& nodes,
                 const std::vector<double>& weights);
  const Eigen::VectorXd& gradient() const { return gradient_; }
  Eigen::VectorXd times(const Eigen::VectorXd& step) const { return matrix_.times(step); }
  Eigen::VectorXd diagonal() const { return matrix_.diagonal_entries(); }

  // Of H with its diagonal `damping` times larger. False where it is not positive definite.
  bool factorize(double damping);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const {  // by the last factor
    return matrix_.solve(right_hand_sides);
  }

  std::vector<Pose> moved(const std::vector<Pose>& nodes, const Eigen::VectorXd& step) const;

 private:
  static constexpr int kSize = kDegreesOfFreedom<Pose>;

  explicit NormalEquations(const FreeNodes& free);

  std::vector<int> places_;  // of nodes in the order of elimination; -1 where held
  std::vector<int> blocks_;  // of `matrix_`, of each constraint between two nodes that are free
  BlockCholesky<kSize> matrix_;
  Eigen::VectorXd gradient_;
};

}  // namespace mapbed
