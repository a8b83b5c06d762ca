#include "algorithms/pose_graph/graph_optimizer.h"

#include <cmath>
#include <optional>
#include <utility>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graduated_weights.h"
#include "algorithms/pose_graph/initial_poses.h"
#include "algorithms/pose_graph/normal_equations.h"
#include "algorithms/pose_graph/position_equations.h"
#include "algorithms/pose_graph/step_control.h"
#include "core/statistics/distributions.h"

namespace mapbed {
namespace {

// What is minimised: losses of those that close loops, or weights where these are given.
struct Losses {
  RobustLoss loss = RobustLoss::none;
  double squared_width = 1.0;
  std::vector<double> fixed_weights = {};  // of each constraint

  RobustCost of(std::size_t constraint, bool closes_loop, double chi_square) const {
    if (!fixed_weights.empty()) {
      return {fixed_weights[constraint] * chi_square, fixed_weights[constraint]};
    }
    if (!closes_loop) return {chi_square, 1.0};
    return robust_cost(loss, squared_width, chi_square);
  }
};

// Poses, and what all constraints say of them.
template <class Pose>
struct Position {
  std::vector<Pose> nodes;
  std::vector<double> chi_squares;
  std::vector<double> weights;
  double cost = 0.0;
};

template <class Pose>
Position<Pose> position_at(const PoseGraph<Pose>& graph, std::vector<Pose> nodes,
                           const Losses& losses) {
  Position<Pose> position{.nodes = std::move(nodes)};
  position.chi_squares.reserve(graph.constraints.size());
  position.weights.reserve(graph.constraints.size());
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const PoseConstraint<Pose>& constraint = graph.constraints[i];
    const double chi_square = chi_square_of(constraint, position.nodes);
    const RobustCost cost = losses.of(i, constraint.closes_loop, chi_square);
    position.chi_squares.push_back(chi_square);
    position.weights.push_back(cost.weight);
    position.cost += cost.cost;
  }
  return position;
}

double sum_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

struct Descent {
  int iterations = 0;
  bool converged = false;
};

// Where a step gains less of what it promises, positions are solved anew for its rotations: in the
// plane alone. From a start that is far off in space they would lead into another optimum.
constexpr double kGoodGain = 0.75;
template <class Pose>
constexpr bool kSolvesPositions = kDegreesOfFreedom<Pose> == 3;
constexpr double kNoCost = 1e-12;  // chi-square below which there is nothing to gain

// Downhill from `position`, which is left at the lowest place that was found.
template <class Control, class Pose>
Descent descend(const PoseGraph<Pose>& graph, const Losses& losses, Control control,
                double min_decrease, int max_iterations, NormalEquations<Pose>& equations,
                Position<Pose>& position) {
  Descent descent;
  bool is_new = true;
  std::optional<PositionEquations<Pose>> positions;
  if (equations.size() == 0) return {.converged = true};
  while (descent.iterations < max_iterations) {
    if (is_new) equations.linearize(graph, position.nodes, position.weights);
    ++descent.iterations;
    const std::optional<Step> step = control.propose(equations);
    if (!step || !step->step.allFinite()) return descent;
    const double least = min_decrease * position.cost + kNoCost;
    const bool is_last = step->predicted <= least && control.is_free();

    Position<Pose> trial = position_at(graph, equations.moved(position.nodes, step->step), losses);
    if (kSolvesPositions<Pose> && !is_last &&
        position.cost - trial.cost < kGoodGain * step->predicted) {
      if (!positions) positions.emplace(graph);
      Position<Pose> other =
          position_at(graph, positions->solve(graph, trial.nodes, trial.weights), losses);
      if (other.cost < trial.cost) trial = std::move(other);
    }
    const double decrease = position.cost - trial.cost;
    is_new = decrease > 0.0;
    if (is_new) {
      position = std::move(trial);
      control.accepted(decrease / step->predicted);
    }
    if (is_last || (is_new && decrease <= least && control.is_free())) {
      descent.converged = true;
      return descent;
    }
    if (!is_new && !control.rejected()) return descent;
  }
  return descent;
}

template <class Pose>
Descent descend(const PoseGraph<Pose>& graph, const Losses& losses,
                const GraphOptimizationOptions& options, int max_iterations,
                NormalEquations<Pose>& equations, Position<Pose>& position) {
  const auto with = [&](auto control) {
    return descend(graph, losses, control, options.min_decrease, max_iterations, equations,
                   position);
  };
  switch (options.algorithm) {
    case GraphAlgorithm::gauss_newton:
      return with(GaussNewton<Pose>());
    case GraphAlgorithm::levenberg_marquardt:
      return with(LevenbergMarquardt<Pose>());
    case GraphAlgorithm::dogleg:
      return with(Dogleg<Pose>());
  }
  return {};
}

// Of the constraints that may be wrong.
template <class Pose>
std::vector<double> doubted(const PoseGraph<Pose>& graph, const std::vector<double>& chi_squares) {
  std::vector<double> result;
  for (std::size_t i = 0; i < chi_squares.size(); ++i) {
    if (graph.constraints[i].closes_loop) result.push_back(chi_squares[i]);
  }
  return result;
}

// The constraints that count at given weights, and the equations of these alone: what false loop
// closures fill in would cost more than all the rest.
template <class Pose>
class WeighedGraph {
 public:
  // Downhill at these weights.
  Descent descend(const PoseGraph<Pose>& graph, const std::vector<double>& weights,
                  const GraphOptimizationOptions& options, int max_iterations,
                  std::vector<Pose>& nodes) {
    std::vector<bool> counts;
    for (const double weight : weights) counts.push_back(weight > 0.0);
    if (!equations_ || counts != counts_) select(graph, std::move(counts));
    Losses losses;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (counts_[i]) losses.fixed_weights.push_back(weights[i]);
    }
    Position<Pose> position = position_at(graph_, std::move(nodes), losses);
    if (!kSolvesPositions<Pose>) leave_for_chordal(losses, position);
    const Descent descent =
        mapbed::descend(graph_, losses, options, max_iterations, *equations_, position);
    nodes = std::move(position.nodes);
    return descent;
  }

 private:
  // Graduated non-convexity asks for the global minimum at given weights. Where false loop closures
  // have turned poses in space over, no descent leads back: chordal poses at these weights, where
  // they cost less.
  void leave_for_chordal(const Losses& losses, Position<Pose>& position) const {
    PoseGraph<Pose> weighed = graph_;
    for (std::size_t i = 0; i < weighed.constraints.size(); ++i) {
      weighed.constraints[i].information *= losses.fixed_weights[i];
    }
    Position<Pose> chordal = position_at(graph_, chordal_poses(weighed), losses);
    if (chordal.cost < position.cost) position = std::move(chordal);
  }

  void select(const PoseGraph<Pose>& graph, std::vector<bool> counts) {
    counts_ = std::move(counts);
    graph_ = {.nodes = graph.nodes, .held = graph.held};
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i]) graph_.constraints.push_back(graph.constraints[i]);
    }
    equations_.emplace(graph_);
  }

  std::vector<bool> counts_;
  PoseGraph<Pose> graph_;
  std::optional<NormalEquations<Pose>> equations_;
};

// All constraints first, then the loop closures' weights in turn with the minimum at these.
template <class Pose>
Descent descend_graduated(const PoseGraph<Pose>& graph, const Losses& losses,
                          const GraphOptimizationOptions& options, Position<Pose>& position) {
  constexpr int kAtATime = 5;  // iterations; the next weights begin where these end
  WeighedGraph<Pose> weighed;
  std::vector<Pose> nodes = std::move(position.nodes);
  std::vector<double> weights(graph.constraints.size(), 1.0);
  Descent all = weighed.descend(graph, weights, options, options.max_iterations, nodes);
  position = position_at(graph, nodes, Losses{});
  GraduatedWeights graduated(losses.loss, losses.squared_width,
                             doubted(graph, position.chi_squares));
  while (!graduated.is_done()) {
    const std::vector<double> of_loops = graduated.next(doubted(graph, position.chi_squares));
    auto weight = of_loops.begin();
    for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
      if (graph.constraints[i].closes_loop) weights[i] = *weight++;
    }
    const int at_most = graduated.is_done() ? options.max_iterations : kAtATime;
    const Descent part = weighed.descend(graph, weights, options, at_most, nodes);
    all.iterations += part.iterations;
    all.converged = part.converged;
    position = position_at(graph, nodes, Losses{.fixed_weights = weights});
  }
  return all;
}

}  // namespace

template <class Pose>
GraphOptimum<Pose> optimize(const PoseGraph<Pose>& graph, const GraphOptimizationOptions& options) {
  const RobustLossOptions& robust = options.robust;
  const Losses losses{
      .loss = robust.loss,
      .squared_width = is_graduated(robust.loss)
                           ? chi_square_quantile(robust.inlier_probability, kDegreesOfFreedom<Pose>)
                           : robust.width * robust.width};
  Position<Pose> position = position_at(graph, graph.nodes, losses);
  GraphOptimum<Pose> optimum{.chi2_before = sum_of(position.chi_squares),
                             .cost_before = position.cost};
  Descent descent;
  if (is_graduated(robust.loss)) {
    descent = descend_graduated(graph, losses, options, position);
  } else {
    NormalEquations<Pose> equations(graph);
    descent = descend(graph, losses, options, options.max_iterations, equations, position);
  }
  optimum.weights = position.weights;
  optimum.iterations = descent.iterations;
  optimum.converged = descent.converged;
  position = position_at(graph, std::move(position.nodes), losses);
  optimum.chi2_after = sum_of(position.chi_squares);
  optimum.cost_after = position.cost;
  optimum.poses = std::move(position.nodes);
  return optimum;
}

template GraphOptimum<Pose2> optimize(const PoseGraph<Pose2>&, const GraphOptimizationOptions&);
template GraphOptimum<Pose3> optimize(const PoseGraph<Pose3>&, const GraphOptimizationOptions&);

}  // namespace mapbed
