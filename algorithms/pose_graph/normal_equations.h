#pragma once

#include <memory>
#include <vector>

#include "algorithms/pose_graph/constraint_error.h"

namespace mapbed {

// The normal equations of a graph, H step = -gradient with H = sum of J' w information J, over the
// nodes that are not held. Which entries of H there are, and in which order nodes are eliminated
// (approximate minimum degree of the graph of nodes), is found once; values are filled in place.
// Vectors hold the nodes' steps in the order of elimination: that of node n begins at offset_of(n).
template <class Pose>
class NormalEquations {
 public:
  explicit NormalEquations(const PoseGraph<Pose>& graph);
  ~NormalEquations();
  NormalEquations(const NormalEquations&) = delete;
  NormalEquations& operator=(const NormalEquations&) = delete;

  int size() const;               // of vectors
  int offset_of(int node) const;  // -1 of a node that is held

  // `graph` with the structure that this was made of, `weights` one for each constraint.
  void linearize(const PoseGraph<Pose>& graph, const std::vector<Pose>& nodes,
                 const std::vector<double>& weights);
  const Eigen::VectorXd& gradient() const;
  Eigen::VectorXd times(const Eigen::VectorXd& step) const;  // H step

  // Of H with its diagonal `damping` times larger. False where it is not positive definite.
  bool factorize(double damping);
  Eigen::VectorXd diagonal() const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;  // by the last factors

  std::vector<Pose> moved(const std::vector<Pose>& nodes, const Eigen::VectorXd& step) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mapbed
