#include "algorithms/pose_graph/initial_poses.h"

#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "algorithms/pose_graph/free_nodes.h"
#include "algorithms/pose_graph/fronts/block_cholesky.h"
#include "algorithms/pose_graph/position_equations.h"

namespace mapbed {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

template <class Pose>
inline constexpr int kDimension = kDegreesOfFreedom<Pose> == 3 ? 2 : 3;
template <class Pose>
using Rotation = Eigen::Matrix<double, kDimension<Pose>, kDimension<Pose>>;

Rotation<Pose2> rotation(const Pose2& pose) {
  return Eigen::Rotation2Dd(pose.theta).toRotationMatrix();
}
Rotation<Pose3> rotation(const Pose3& pose) {
  return pose.rotation.toRotationMatrix();
}
Pose2 turned(const Pose2& pose, const Rotation<Pose2>& turn) {
  return {pose.x, pose.y, std::atan2(turn(1, 0), turn(0, 0))};
}
Pose3 turned(const Pose3& pose, const Rotation<Pose3>& turn) {
  return {pose.position, Eigen::Quaterniond(turn).normalized()};
}

// The nearest rotation. It fails for none, as the last column may be turned over.
template <int kSize>
Eigen::Matrix<double, kSize, kSize> projected(const Eigen::Matrix<double, kSize, kSize>& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix<double, kSize, kSize>> svd(
      matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix<double, kSize, kSize> u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0) u.col(kSize - 1) *= -1.0;
  return u * svd.matrixV().transpose();
}

// How sharp a constraint's rotation is, by the mean of its information about all axes.
double sharpness(const PoseConstraint<Pose2>& constraint) {
  return constraint.information(2, 2);
}
double sharpness(const PoseConstraint<Pose3>& constraint) {
  return constraint.information.bottomRightCorner<3, 3>().trace() / 3.0;
}

// Of all free nodes: transposed rotations, one below the other; they obey
// R_to' = R_from_to' R_from' for each constraint.
template <class Pose>
std::optional<std::vector<Rotation<Pose>>> chordal_rotations(const PoseGraph<Pose>& graph,
                                                             const FreeNodes& free) {
  constexpr int kSize = kDimension<Pose>;
  BlockCholesky<kSize> matrix(free.count, free.pairs);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(matrix.size(), kSize);
  const auto place_of = [&](int node) {
    const int number = free.numbers[index(node)];
    return number < 0 ? -1 : matrix.place_of(number);
  };
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const PoseConstraint<Pose>& constraint = graph.constraints[i];
    if (constraint.from == constraint.to) continue;
    const double weight = sharpness(constraint);
    const Rotation<Pose> turn = weight * rotation(constraint.from_from_to);
    const int a = place_of(constraint.from);
    const int b = place_of(constraint.to);
    if (a >= 0) matrix.diagonal(a).diagonal().array() += weight;
    if (b >= 0) matrix.diagonal(b).diagonal().array() += weight;
    if (a >= 0 && b < 0) {
      right.middleRows<kSize>(kSize * a) +=
          turn * rotation(graph.nodes[index(constraint.to)]).transpose();
    } else if (a < 0 && b >= 0) {
      right.middleRows<kSize>(kSize * b) +=
          turn.transpose() * rotation(graph.nodes[index(constraint.from)]).transpose();
    } else if (a >= 0 && b >= 0) {
      auto& block = matrix.off_diagonal(matrix.block_of(index(free.pair_of_constraint[i])));
      if (a > b)
        block -= turn;
      else
        block -= turn.transpose();
    }
  }
  if (!matrix.factorize(Eigen::VectorXd::Zero(matrix.size()))) return {};
  const Eigen::MatrixXd transposed = matrix.solve(right);
  std::vector<Rotation<Pose>> rotations;
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    const int place = place_of(static_cast<int>(node));
    rotations.push_back(
        place < 0 ? rotation(graph.nodes[node])
                  : projected<kSize>(transposed.middleRows<kSize>(kSize * place).transpose()));
  }
  return rotations;
}

}  // namespace

template <class Pose>
std::vector<Pose> spanning_tree_poses(const PoseGraph<Pose>& graph) {
  std::vector<std::vector<std::size_t>> constraints_of(graph.nodes.size());
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    constraints_of[index(graph.constraints[i].from)].push_back(i);
    constraints_of[index(graph.constraints[i].to)].push_back(i);
  }
  std::vector<Pose> poses = graph.nodes;
  std::vector<bool> has_pose = held_nodes(graph);
  std::vector<int> reached;  // breadth first
  for (std::size_t node = 0; node < poses.size(); ++node) {
    if (has_pose[node]) reached.push_back(static_cast<int>(node));
  }
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int node = reached[next];
    for (const std::size_t i : constraints_of[index(node)]) {
      const PoseConstraint<Pose>& constraint = graph.constraints[i];
      const bool is_forward = constraint.from == node;
      const int other = is_forward ? constraint.to : constraint.from;
      if (has_pose[index(other)]) continue;
      has_pose[index(other)] = true;
      poses[index(other)] = poses[index(node)] * (is_forward ? constraint.from_from_to
                                                             : inverse(constraint.from_from_to));
      reached.push_back(other);
    }
  }
  return poses;
}

template <class Pose>
std::vector<Pose> chordal_poses(const PoseGraph<Pose>& graph) {
  const FreeNodes free(graph);
  const auto rotations = chordal_rotations(graph, free);
  if (!rotations) return spanning_tree_poses(graph);
  std::vector<Pose> poses = graph.nodes;
  for (std::size_t node = 0; node < poses.size(); ++node) {
    if (free.numbers[node] >= 0) poses[node] = turned(poses[node], (*rotations)[node]);
  }
  return PositionEquations<Pose>(graph).solve(graph, poses,
                                              std::vector<double>(graph.constraints.size(), 1.0));
}

template std::vector<Pose2> spanning_tree_poses(const PoseGraph<Pose2>&);
template std::vector<Pose3> spanning_tree_poses(const PoseGraph<Pose3>&);
template std::vector<Pose2> chordal_poses(const PoseGraph<Pose2>&);
template std::vector<Pose3> chordal_poses(const PoseGraph<Pose3>&);

}  // namespace mapbed
