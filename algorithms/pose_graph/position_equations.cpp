#include "algorithms/pose_graph/position_equations.h"

#include "algorithms/pose_graph/constraint_error.h"

namespace mapbed {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

void move_by(const Eigen::Vector2d& step, Pose2& pose) {
  pose.x += step.x();
  pose.y += step.y();
}
void move_by(const Eigen::Vector3d& step, Pose3& pose) {
  pose.position += step;
}

}  // namespace

template <class Pose>
PositionEquations<Pose>::PositionEquations(const PoseGraph<Pose>& graph)
    : free_(graph), matrix_(free_.count, free_.pairs) {}

template <class Pose>
std::vector<Pose> PositionEquations<Pose>::solve(const PoseGraph<Pose>& graph,
                                                 const std::vector<Pose>& nodes,
                                                 const std::vector<double>& weights) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(matrix_.size());
  const auto place_of = [&](int node) {
    const int number = free_.numbers[index(node)];
    return number < 0 ? -1 : matrix_.place_of(number);
  };
  matrix_.set_zero();
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const PoseConstraint<Pose>& constraint = graph.constraints[i];
    if (weights[i] == 0.0 || constraint.from == constraint.to) continue;
    const LinearError<Pose> linear = linear_error(
        constraint.from_from_to, nodes[index(constraint.from)], nodes[index(constraint.to)]);
    // By the step of `to`; by that of `from` it is the negative.
    const auto turn = linear.by_to.template topLeftCorner<kSize, kSize>();
    const typename BlockCholesky<kSize>::Block weight =
        weights[i] * turn.transpose() *
        constraint.information.template topLeftCorner<kSize, kSize>() * turn;
    const Eigen::Matrix<double, kSize, 1> pull =
        weights[i] * turn.transpose() *
        (constraint.information.template topRows<kSize>() * linear.error);
    const int a = place_of(constraint.from);
    const int b = place_of(constraint.to);
    if (a >= 0) {
      matrix_.diagonal(a) += weight;
      gradient.segment<kSize>(kSize * a) -= pull;
    }
    if (b >= 0) {
      matrix_.diagonal(b) += weight;
      gradient.segment<kSize>(kSize * b) += pull;
    }
    if (a >= 0 && b >= 0) {
      matrix_.off_diagonal(matrix_.block_of(index(free_.pair_of_constraint[i]))) -= weight;
    }
  }
  std::vector<Pose> moved = nodes;
  if (!matrix_.factorize(Eigen::VectorXd::Zero(matrix_.size()))) return moved;
  const Eigen::VectorXd step = matrix_.solve(-gradient);
  if (!step.allFinite()) return moved;
  for (std::size_t node = 0; node < moved.size(); ++node) {
    const int place = place_of(static_cast<int>(node));
    if (place >= 0) move_by(step.segment<kSize>(kSize * place), moved[node]);
  }
  return moved;
}

template class PositionEquations<Pose2>;
template class PositionEquations<Pose3>;

}  // namespace mapbed
