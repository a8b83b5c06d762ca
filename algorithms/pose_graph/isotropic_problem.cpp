#include "algorithms/pose_graph/isotropic_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "algorithms/pose_graph/constraint_error.h"

namespace mapbed {
namespace {

constexpr int kMostIterations = 100;
constexpr double kLeastDamping = 1e-12;
constexpr double kLeastFall = 1e-12;  // of f, as a part of it and of 1

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

Eigen::Matrix3d homogeneous(const Pose2& pose) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  return (Eigen::Matrix3d() << c, -s, pose.x, s, c, pose.y, 0.0, 0.0, 1.0).finished();
}

Eigen::Matrix4d homogeneous(const Pose3& pose) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = pose.position;
  return matrix;
}

// The inverse of the mean variance; 0 where there is none.
template <int D>
double mean_information(const Eigen::Matrix<double, D, D>& information) {
  const Eigen::LLT<Eigen::Matrix<double, D, D>> cholesky(information);
  if (cholesky.info() != Eigen::Success) return 0.0;
  const double trace =
      Eigen::Matrix<double, D, D>(cholesky.solve(Eigen::Matrix<double, D, D>::Identity())).trace();
  return std::isfinite(trace) && trace > 0.0 ? D / trace : 0.0;
}

// The derivatives of f at poses: tangents are those of moved().
template <class Pose>
class Expansion {
 public:
  static constexpr int kD = kDimension<Pose>;
  static constexpr int kBlock = IsotropicProblem<Pose>::kBlock;
  static constexpr int kSize = kDegreesOfFreedom<Pose>;
  using Matrix = Eigen::Matrix<double, kD, kBlock>;  // T of a node, and its derivatives

  Expansion(const IsotropicProblem<Pose>& problem, const std::vector<Pose>& poses) {
    std::vector<Matrix> t;
    for (const Pose& pose : poses) t.push_back(homogeneous(pose).template topRows<kD>());
    std::vector<Matrix> g(t.size(), Matrix::Zero());  // T M
    for (const NodeBlock<kBlock>& block : problem.blocks) {
      g[at(block.col)] += t[at(block.row)] * block.value;
      if (block.row != block.col) g[at(block.row)] += t[at(block.col)] * block.value.transpose();
    }
    blocks_ = problem.blocks;
    gradient_.setZero(problem.nodes * kSize);
    for (int i = 0; i < problem.nodes; ++i) {
      tangents_.push_back(tangents_at(t[at(i)]));
      for (int a = 0; a < kSize; ++a) {
        gradient_[i * kSize + a] = g[at(i)].cwiseProduct(tangents_[at(i)][at(a)]).sum();
      }
      const Eigen::Matrix<double, kD, kD> multiplier =
          t[at(i)].template leftCols<kD>().transpose() * g[at(i)].template leftCols<kD>();
      NodeBlock<kBlock> lambda{i, i, Eigen::Matrix<double, kBlock, kBlock>::Zero()};
      lambda.value.template topLeftCorner<kD, kD>() = -0.5 * (multiplier + multiplier.transpose());
      blocks_.push_back(lambda);
    }
  }

  const Eigen::VectorXd& gradient() const { return gradient_; }  // half of it
  std::vector<NodeBlock<kBlock>> take_hessian() { return std::move(blocks_); }

  // Half the second derivatives, the diagonal of nodes of `held` and of all, by `damping`, larger.
  std::vector<NodeBlock<kSize>> hessian(const std::vector<int>& held, double damping) const {
    std::vector<NodeBlock<kSize>> result;
    for (const NodeBlock<kBlock>& block : blocks_) {
      NodeBlock<kSize> projected{block.row, block.col, {}};
      for (int b = 0; b < kSize; ++b) {
        const Matrix column = tangents_[at(block.col)][at(b)] * block.value.transpose();
        for (int a = 0; a < kSize; ++a) {
          projected.value(a, b) = tangents_[at(block.row)][at(a)].cwiseProduct(column).sum();
        }
      }
      // Of M alone, which is positive.
      if (block.row == block.col && &block - blocks_.data() < first_multiplier()) {
        projected.value.diagonal() *= 1.0 + damping;
      }
      result.push_back(projected);
    }
    for (const int node : held) {
      result.push_back({node, node, scale() * Eigen::Matrix<double, kSize, kSize>::Identity()});
    }
    return result;
  }

 private:
  std::ptrdiff_t first_multiplier() const {
    return static_cast<std::ptrdiff_t>(blocks_.size() - tangents_.size());
  }

  double scale() const {
    double largest = 0.0;
    for (const NodeBlock<kBlock>& block : blocks_) {
      if (block.row == block.col) largest = std::max(largest, block.value.trace());
    }
    return largest;
  }

  // Of T by a step of moved(): positions in the map's frame, turns in the node's own.
  static std::array<Matrix, kSize> tangents_at(const Matrix& t) {
    std::array<Matrix, kSize> tangents;
    tangents.fill(Matrix::Zero());
    for (int a = 0; a < kD; ++a) tangents[at(a)](a, kD) = 1.0;
    // A turn about an axis takes one of the other two axes to the next: in the plane x to y.
    for (int a = kD; a < kSize; ++a) {
      const int from = kD == 2 ? 0 : (a - kD + 1) % 3;
      const int to = kD == 2 ? 1 : (a - kD + 2) % 3;
      tangents[at(a)].col(from) = t.col(to);
      tangents[at(a)].col(to) = -t.col(from);
    }
    return tangents;
  }

  std::vector<NodeBlock<kBlock>> blocks_;  // of M, then of -Lambda
  std::vector<std::array<Matrix, kSize>> tangents_;
  Eigen::VectorXd gradient_;
};

// f by the errors themselves.
template <class Pose>
double objective_of(const PoseGraph<Pose>& graph, const std::vector<Pose>& poses) {
  constexpr int kD = kDimension<Pose>;
  double sum = 0.0;
  for (const PoseConstraint<Pose>& c : graph.constraints) {
    const auto [kappa, tau] = isotropic_weights<Pose>(c.information);
    const auto difference = (homogeneous(poses[at(c.from)]) * homogeneous(c.from_from_to) -
                             homogeneous(poses[at(c.to)]))
                                .eval();
    sum += kappa * difference.template topLeftCorner<kD, kD>().squaredNorm() +
           tau * difference.template topRightCorner<kD, 1>().squaredNorm();
  }
  return sum;
}

}  // namespace

template <class Pose>
IsotropicWeights isotropic_weights(const PoseInformation<Pose>& information) {
  constexpr int kD = kDimension<Pose>;
  constexpr int kTurns = kDegreesOfFreedom<Pose> - kD;
  const double rotation =
      mean_information<kTurns>(information.template bottomRightCorner<kTurns, kTurns>());
  return {rotation / (kD == 2 ? 2.0 : 8.0),
          mean_information<kD>(information.template topLeftCorner<kD, kD>())};
}

template <class Pose>
IsotropicProblem<Pose> isotropic_problem(const PoseGraph<Pose>& graph) {
  constexpr int kD = kDimension<Pose>;
  IsotropicProblem<Pose> problem;
  problem.nodes = static_cast<int>(graph.nodes.size());
  for (const PoseConstraint<Pose>& c : graph.constraints) {
    const auto [kappa, tau] = isotropic_weights<Pose>(c.information);
    const auto e = homogeneous(c.from_from_to);
    using Block = Eigen::Matrix<double, kD + 1, kD + 1>;
    Block weights = kappa * Block::Identity();
    weights(kD, kD) = tau;
    problem.blocks.push_back({c.from, c.from, e * weights * e.transpose()});
    problem.blocks.push_back({c.to, c.to, weights});
    problem.blocks.push_back({c.from, c.to, -e * weights});

    if (kappa == 0.0 || tau == 0.0) {
      problem.least_part = 0.0;
      continue;
    }
    PoseTangent<Pose> root;  // of the isotropic information
    root.setConstant(std::sqrt(kappa * (kD == 2 ? 2.0 : 8.0)));
    root.template head<kD>().setConstant(std::sqrt(tau));
    const PoseInformation<Pose> scaled =
        root.cwiseInverse().asDiagonal() * c.information * root.cwiseInverse().asDiagonal();
    const auto parts =
        Eigen::SelfAdjointEigenSolver<PoseInformation<Pose>>(scaled, Eigen::EigenvaluesOnly)
            .eigenvalues();
    problem.least_part = std::min(problem.least_part, parts.minCoeff());
    problem.most_part = std::max(problem.most_part, parts.maxCoeff());
  }
  problem.least_part = std::max(problem.least_part, 0.0);
  return problem;
}

template <class Pose>
StationaryPoint<Pose> polish(const PoseGraph<Pose>& graph, const IsotropicProblem<Pose>& problem) {
  constexpr int kSize = kDegreesOfFreedom<Pose>;
  std::vector<int> held;  // a node of each component, for f does not change where all move as one
  const std::vector<int> component = components_of(graph);
  for (std::size_t i = 0; i < component.size(); ++i) {
    if (component[i] == static_cast<int>(held.size())) held.push_back(static_cast<int>(i));
  }

  StationaryPoint<Pose> point{.poses = graph.nodes, .objective = objective_of(graph, graph.nodes)};
  Expansion<Pose> expansion(problem, point.poses);
  SparseFactor<kSize> factor(problem.nodes, expansion.hessian(held, 0.0));
  double damping = 0.0;
  while (!point.converged && point.iterations < kMostIterations && damping < 1e6) {
    ++point.iterations;
    const double larger = std::max(10.0 * damping, kLeastDamping);
    if (!factor.factorize(expansion.hessian(held, damping))) {
      damping = std::max(larger, 1e-6);
      continue;
    }
    const Eigen::VectorXd step = -factor.solve(expansion.gradient());
    const double promised = -step.dot(expansion.gradient());  // the fall of f
    std::vector<Pose> next;
    for (int i = 0; i < problem.nodes; ++i) {
      next.push_back(moved(point.poses[at(i)], PoseTangent<Pose>(step.segment<kSize>(i * kSize))));
    }
    const double objective = objective_of(graph, next);
    const double fall = point.objective - objective;
    point.converged = damping == 0.0 && promised <= kLeastFall * (1.0 + point.objective);
    if (!point.converged && fall < -1e-12 * point.objective) {
      damping = larger;
      continue;
    }
    point.poses = std::move(next);
    point.objective = objective;
    expansion = Expansion<Pose>(problem, point.poses);
    if (fall < 0.25 * promised && !point.converged && promised > 1e-10 * objective) {
      damping = larger;
    } else {
      damping = damping <= kLeastDamping ? 0.0 : 0.1 * damping;
    }
  }
  point.hessian = expansion.take_hessian();
  return point;
}

template IsotropicWeights isotropic_weights<Pose2>(const PoseInformation<Pose2>&);
template IsotropicWeights isotropic_weights<Pose3>(const PoseInformation<Pose3>&);
template IsotropicProblem<Pose2> isotropic_problem(const PoseGraph<Pose2>&);
template IsotropicProblem<Pose3> isotropic_problem(const PoseGraph<Pose3>&);
template StationaryPoint<Pose2> polish(const PoseGraph<Pose2>&, const IsotropicProblem<Pose2>&);
template StationaryPoint<Pose3> polish(const PoseGraph<Pose3>&, const IsotropicProblem<Pose3>&);

}  // namespace mapbed
