#include "algorithms/pose_graph/relative_covariance.h"

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/normal_equations.h"

namespace mapbed {
namespace {

// Of (x, y, theta) of a_from_b.
LinearError<Pose2> linear_motion(const Pose2& map_from_a, const Pose2& map_from_b) {
  return linear_error(Pose2{}, map_from_a, map_from_b);
}

// Of the position of a_from_b, and of its rotation vector in b's frame. An error's own are in the
// frame of the measured pose, and half as large.
LinearError<Pose3> linear_motion(const Pose3& map_from_a, const Pose3& map_from_b) {
  const Pose3 a_from_b = motion_between(map_from_a, map_from_b);
  LinearError<Pose3> linear = linear_error(a_from_b, map_from_a, map_from_b);
  for (PoseInformation<Pose3>* by : {&linear.by_from, &linear.by_to}) {
    by->topRows<3>() =
        a_from_b.rotation.toRotationMatrix() * Eigen::Matrix<double, 3, 6>(by->topRows<3>());
    by->bottomRows<3>() *= 2.0;
  }
  return linear;
}

}  // namespace

template <class Pose>
struct RelativeCovariances<Pose>::State {
  explicit State(const PoseGraph<Pose>& graph)
      : nodes(graph.nodes), component(components_of(graph)), equations(graph) {}

  std::vector<Pose> nodes;
  std::vector<int> component;
  NormalEquations<Pose> equations;
  bool is_positive = false;
};

template <class Pose>
RelativeCovariances<Pose>::RelativeCovariances(const PoseGraph<Pose>& graph,
                                               const std::vector<double>& weights)
    : state_(std::make_unique<State>(graph)) {
  state_->equations.linearize(
      graph, graph.nodes,
      weights.empty() ? std::vector<double>(graph.constraints.size(), 1.0) : weights);
  state_->is_positive = state_->equations.factorize(0.0);
}

template <class Pose>
RelativeCovariances<Pose>::~RelativeCovariances() = default;

template <class Pose>
std::optional<PoseInformation<Pose>> RelativeCovariances<Pose>::between(int a, int b) const {
  constexpr int kSize = kDegreesOfFreedom<Pose>;
  const auto first = static_cast<std::size_t>(a);
  const auto second = static_cast<std::size_t>(b);
  if (!state_->is_positive || state_->component[first] != state_->component[second]) return {};
  const NormalEquations<Pose>& equations = state_->equations;
  PoseInformation<Pose> covariance = PoseInformation<Pose>::Zero();
  if (a == b) return covariance;
  const LinearError<Pose> linear = linear_motion(state_->nodes[first], state_->nodes[second]);
  Eigen::MatrixXd transposed = Eigen::MatrixXd::Zero(equations.size(), kSize);
  const int of_a = equations.offset_of(a);
  const int of_b = equations.offset_of(b);
  if (of_a >= 0) transposed.middleRows<kSize>(of_a) = linear.by_from.transpose();
  if (of_b >= 0) transposed.middleRows<kSize>(of_b) = linear.by_to.transpose();
  const Eigen::MatrixXd solved = equations.solve(transposed);
  if (of_a >= 0) covariance += linear.by_from * solved.middleRows<kSize>(of_a);
  if (of_b >= 0) covariance += linear.by_to * solved.middleRows<kSize>(of_b);
  return PoseInformation<Pose>(0.5 * (covariance + covariance.transpose()));
}

template class RelativeCovariances<Pose2>;
template class RelativeCovariances<Pose3>;

}  // namespace mapbed
