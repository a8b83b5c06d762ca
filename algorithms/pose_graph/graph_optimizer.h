#pragma once

#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/pose_graph/robust_loss.h"
#include "core/config/option.h"

namespace mapbed {

enum class GraphAlgorithm : int { gauss_newton, levenberg_marquardt, dogleg };

struct GraphOptimizationOptions {
  GraphAlgorithm algorithm = GraphAlgorithm::levenberg_marquardt;
  int max_iterations = 500;
  double min_decrease = 1e-8;  // of the cost, as a fraction; it ends where a step promises less
  RobustLossOptions robust;
};

template <class Visitor>
void visit_fields(GraphOptimizationOptions& o, Visitor&& visit) {
  visit("algorithm", o.algorithm, {"gauss_newton", "levenberg_marquardt", "dogleg"},
        "how steps are made; Gauss-Newton takes each as it comes");
  visit("max_iterations", o.max_iterations, between(0, 100000),
        "systems of equations that are solved at most");
  visit("min_decrease", o.min_decrease, between(1e-15, 1.0),
        "the end is where a step promises less than this fraction of the cost");
  visit("robust", o.robust, "constraints that close loops and may be wrong");
}

template <class Pose>
struct GraphOptimum {
  std::vector<Pose> poses;
  // Sum of error' information error over all constraints, whatever their weights: (6.6), doubled.
  double chi2_before = 0.0;
  double chi2_after = 0.0;
  // Of the losses, which is what falls; the same without a robust one.
  double cost_before = 0.0;
  double cost_after = 0.0;
  int iterations = 0;  // systems of equations that were solved
  bool converged = false;
  std::vector<double> weights;  // of each constraint in the end; 0: switched off
};

// The poses at which the constraints cost the least, found by nonlinear least squares from the
// graph's own poses: a local optimum, so that a good start matters (initial_poses.h). Nodes that
// held_nodes() names keep their poses.
template <class Pose>
GraphOptimum<Pose> optimize(const PoseGraph<Pose>& graph,
                            const GraphOptimizationOptions& options = {});

}  // namespace mapbed
