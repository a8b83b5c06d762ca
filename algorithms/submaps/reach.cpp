#include "algorithms/submaps/reach.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <Eigen/Dense>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kLever = 5.0;     // [m] that an error of heading is worth, where paths are chosen
constexpr double kCounted = 1e-3;  // weights below this are none

struct Step {
  int to = 0;
  Pose2 from_from_to;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // in the frame of `to`
  double cost = 0.0;
};

std::vector<std::vector<Step>> steps_of(const PoseGraph<Pose2>& graph,
                                        const std::vector<double>& weights) {
  std::vector<std::vector<Step>> steps(graph.nodes.size());
  for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
    const PoseConstraint<Pose2>& constraint = graph.constraints[k];
    const double weight = k < weights.size() ? weights[k] : 1.0;
    if (weight < kCounted) continue;
    const Eigen::Matrix3d covariance = (weight * constraint.information).inverse();
    const double cost = covariance(0, 0) + covariance(1, 1) + kLever * kLever * covariance(2, 2);
    CHECK(cost > 0.0);
    const auto from = static_cast<std::size_t>(constraint.from);
    const auto to = static_cast<std::size_t>(constraint.to);
    steps[from].push_back({constraint.to, constraint.from_from_to, covariance, cost});
    const Pose2 back = inverse(constraint.from_from_to);
    steps[to].push_back(
        {constraint.from, back, seen_from(covariance, constraint.from_from_to), cost});
  }
  return steps;
}

}  // namespace

Eigen::Matrix3d seen_from(const Eigen::Matrix3d& in_b, const Pose2& a_from_b) {
  Eigen::Matrix3d adjoint = Eigen::Matrix3d::Identity();
  const double c = std::cos(a_from_b.theta), s = std::sin(a_from_b.theta);
  adjoint.topLeftCorner<2, 2>() << c, -s, s, c;
  adjoint(0, 2) = a_from_b.y;
  adjoint(1, 2) = -a_from_b.x;
  return adjoint * in_b * adjoint.transpose();
}

std::vector<Reach> reach_of(const PoseGraph<Pose2>& graph, const std::vector<double>& weights,
                            int node) {
  CHECK(node >= 0 && static_cast<std::size_t>(node) < graph.nodes.size());
  const std::vector<std::vector<Step>> steps = steps_of(graph, weights);
  struct Found {
    double cost = std::numeric_limits<double>::infinity();
    // Of the node at the path's beginning as seen from this one, in the frame of this one.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  };
  std::vector<Found> found(graph.nodes.size());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  found[static_cast<std::size_t>(node)].cost = 0.0;
  next.emplace(0.0, node);
  while (!next.empty()) {
    const auto [cost, at] = next.top();
    next.pop();
    const Found& here = found[static_cast<std::size_t>(at)];
    if (cost > here.cost) continue;
    for (const Step& step : steps[static_cast<std::size_t>(at)]) {
      Found& there = found[static_cast<std::size_t>(step.to)];
      if (cost + step.cost >= there.cost) continue;
      there.cost = cost + step.cost;
      // Errors in the frame of `to`, of the whole chain from it back to `node`.
      there.covariance = step.covariance + seen_from(here.covariance, inverse(step.from_from_to));
      next.emplace(there.cost, step.to);
    }
  }
  std::vector<Reach> result(graph.nodes.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].cost == std::numeric_limits<double>::infinity()) continue;
    // An error of heading moves what lies far off: seen as an error of the position there.
    const Pose2 node_seen =
        motion_between(graph.nodes[i], graph.nodes[static_cast<std::size_t>(node)]);
    Eigen::Matrix3d moves = Eigen::Matrix3d::Identity();
    moves(0, 2) = -node_seen.y;
    moves(1, 2) = node_seen.x;
    result[i] = {true, moves * found[i].covariance * moves.transpose()};
  }
  return result;
}

}  // namespace mapbed
