#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/pose_graph/sparse_factor.h"

namespace mapbed {

struct IncrementalGraphOptions {
  // A node that is further than this from where its constraints were linearised has all constraints
  // linearised anew, at the poses as they are then.
  double max_move = 0.05;   // [m]
  double max_turn = 0.02;   // [rad]
  int max_iterations = 30;  // linearisations for one change, or for converge()
};

// A graph whose constraints are added and taken back, as a search over data associations does:
// poses and J of (6.7) follow each change by a change of the factor of the information matrix,
// (6.11) and (6.12), and one substitution. A removal takes out exactly the rows that stand in the
// factor for the constraint. The constraints are linearised anew, and the factor made anew, where
// poses have moved too far, where changes have spoiled digits, and where the factor has twice the
// entries that it had when its order was found.
//
// Optima are local ones, found by Gauss-Newton steps that are halved where J would grow; for a
// start that is far off, or constraints that may be wrong, see graph_optimizer.h. Copies share
// nothing: 0.01 ms for 200 nodes.
template <class Pose>
class IncrementalGraph {
 public:
  // A prior on the first node fixes the frame of the map. Whatever it is, the node keeps its pose,
  // for nothing else says where it is.
  explicit IncrementalGraph(const Pose& map_from_first, const IncrementalGraphOptions& options = {},
                            const PoseInformation<Pose>& prior = 1e4 *
                                                                 PoseInformation<Pose>::Identity());
  // A graph that is connected, at its poses; its constraints are known by their indices. The prior
  // is on where its first node is.
  explicit IncrementalGraph(const PoseGraph<Pose>& graph,
                            const IncrementalGraphOptions& options = {},
                            const PoseInformation<Pose>& prior = 1e4 *
                                                                 PoseInformation<Pose>::Identity());

  // All constraints have a positive definite information. Each is known by the number returned, in
  // copies too.

  // A new node, whose index is nodes() before: `from` or `to` of the constraint. It starts where
  // the constraint says.
  int add_node(const PoseConstraint<Pose>& constraint);
  // Between two nodes that there are.
  int add(const PoseConstraint<Pose>& constraint);
  // False, and nothing has changed, where a part of the graph would hang on nothing.
  bool remove(int number);

  int nodes() const { return static_cast<int>(poses_.size()); }
  const std::vector<Pose>& poses() const { return poses_; }  // map_from_node, at the optimum
  // J of (6.7) there, as linearised: the sum of error' information error.
  double objective() const { return factor_->minimum(); }
  double log_likelihood() const { return -0.5 * objective(); }  // up to constants of densities
  // With them: the sum of 1/2 ln det(information / 2 pi), without which sets of different
  // constraints cannot be compared by densities. In the coordinates of errors.
  double log_density() const { return log_normalizer_ + log_likelihood(); }
  // Of the error of a constraint between two nodes, if their distance is as the poses say: what
  // the graph knows about it. Position in b's frame; heading [rad], in space the vector part of
  // the quaternion.
  PoseInformation<Pose> covariance_between(int a, int b) const;

  // Linearises until no node moves by 1e-9 (m, rad) any more, that is to an optimum of the problem
  // that is not linear. False where max_iterations do not suffice.
  bool converge();

  PoseGraph<Pose> graph() const;  // the constraints that hold now, at poses()
  int linearizations() const { return linearizations_; }  // of the whole graph, so far

 private:
  static constexpr int kSize = kDegreesOfFreedom<Pose>;
  struct Held {
    PoseConstraint<Pose> constraint;
    NodeRows<kSize> rows;  // as they stand in the factor
  };

  NodeRows<kSize> prior_rows() const;
  NodeRows<kSize> rows_of(const PoseConstraint<Pose>& constraint) const;
  int hold(const PoseConstraint<Pose>& constraint, const NodeRows<kSize>& rows);
  void follow();
  void take_step(Eigen::VectorXd step);
  void linearize();
  bool is_connected_without(int number) const;
  double objective_at(const std::vector<Pose>& poses) const;
  double largest_excess(const Eigen::VectorXd& step) const;
  void update_poses(const Eigen::VectorXd& step);

  IncrementalGraphOptions options_;
  Pose map_from_first_;
  PoseInformation<Pose> prior_;
  std::vector<Pose> linearized_at_, poses_;
  std::vector<std::optional<Held>> constraints_;  // by number; none: removed
  std::vector<std::pair<int, int>> pairs_;        // of their nodes; 0, 0: removed
  std::optional<SparseFactor<kSize>> factor_;     // always there
  std::size_t blocks_when_ordered_ = 0;
  double log_normalizer_ = 0.0;
  int linearizations_ = 0;
};

}  // namespace mapbed
