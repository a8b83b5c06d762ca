#include "algorithms/pose_graph/certificate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "algorithms/pose_graph/isotropic_problem.h"
#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr int kMostLanczosSteps = 60;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

Eigen::Matrix2d rotation_of(const Pose2& pose) {
  return Eigen::Rotation2Dd(pose.theta).toRotationMatrix();
}

Eigen::Matrix3d rotation_of(const Pose3& pose) {
  return pose.rotation.toRotationMatrix();
}

double turn_between(const Pose2& a, const Pose2& b) {
  return std::abs(normalized_angle(b.theta - a.theta));
}

double turn_between(const Pose3& a, const Pose3& b) {
  return angle_between(a, b);
}

// S of rotations, translations minimised over: vectors hold d + 1 numbers a node, of which the last
// is not used.
template <class Pose>
class RotationHessian {
 public:
  static constexpr int kD = kDimension<Pose>;
  static constexpr int kBlock = kD + 1;
  using Block = Eigen::Matrix<double, kBlock, kBlock>;

  RotationHessian(const PoseGraph<Pose>& graph, const StationaryPoint<Pose>& point)
      : component_(components_of(graph)), blocks_(point.hessian) {
    for (const NodeBlock<kBlock>& block : blocks_) {
      if (block.row == block.col) scale_ = std::max(scale_, block.value.trace());
    }
    // Translations of one node of a component are held: f does not change where all move.
    for (std::size_t i = 0; i < component_.size(); ++i) {
      if (component_[i] < components_) continue;
      ++components_;
      NodeBlock<kBlock> hold{static_cast<int>(i), static_cast<int>(i), Block::Zero()};
      hold.value(kD, kD) = scale_;
      blocks_.push_back(hold);
    }
    known_.setZero(nodes() * kBlock, kD);
    for (int i = 0; i < nodes(); ++i) {
      known_.template middleRows<kD>(i * kBlock) = rotation_of(point.poses[at(i)]).transpose();
    }
    factor_.emplace(nodes(), blocks_);
  }

  int nodes() const { return static_cast<int>(component_.size()); }
  double scale() const { return scale_; }

  // Whether S + eta is positive definite.
  bool factorize(double eta) {
    std::vector<NodeBlock<kBlock>> blocks = blocks_;
    for (int i = 0; i < nodes(); ++i) {
      NodeBlock<kBlock> shift{i, i, eta * Block::Identity()};
      shift.value(kD, kD) = 0.0;
      blocks.push_back(shift);
    }
    eta_ = eta;
    return factor_->factorize(blocks);
  }

  // The minimal eigenvalue but for the known ones, by Lanczos' steps with (S + eta)^-1 from a
  // random vector, each made orthogonal to all before. S + eta was factorised.
  double min_eigenvalue() const {
    Rng rng(1);
    Eigen::VectorXd v =
        Eigen::VectorXd::NullaryExpr(nodes() * kBlock, [&] { return rng.normal(); });
    const int most = std::min(kMostLanczosSteps, kD * nodes() - kD * components_);
    std::vector<Eigen::VectorXd> basis;
    std::vector<double> alpha, beta;
    double largest = 0.0;
    v = without_known(v).normalized();
    for (int k = 0; k < most; ++k) {
      basis.push_back(v);
      Eigen::VectorXd w = without_known(factor_->solve(v));
      alpha.push_back(w.dot(v));
      for (int twice = 0; twice < 2; ++twice) {
        for (const Eigen::VectorXd& b : basis) w -= w.dot(b) * b;
      }
      beta.push_back(w.norm());
      const auto size = static_cast<Eigen::Index>(alpha.size());
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
      ritz.computeFromTridiagonal(Eigen::Map<Eigen::VectorXd>(alpha.data(), size),
                                  Eigen::Map<Eigen::VectorXd>(beta.data(), size - 1));
      largest = ritz.eigenvalues()[size - 1];
      const double residual = beta.back() * std::abs(ritz.eigenvectors()(size - 1, size - 1));
      if (residual <= 1e-6 * largest) break;
      v = w / beta.back();
    }
    return largest > 0.0 ? 1.0 / largest - eta_ : 0.0;
  }

 private:
  // Rows of all rotations of a component together are null vectors.
  Eigen::VectorXd without_known(Eigen::VectorXd v) const {
    Eigen::MatrixXd along = Eigen::MatrixXd::Zero(kD, components_);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(components_);
    for (int i = 0; i < nodes(); ++i) {
      v[i * kBlock + kD] = 0.0;
      count[component_[at(i)]] += 1.0;
      along.col(component_[at(i)]) += known_.template middleRows<kD>(i * kBlock).transpose() *
                                      v.template segment<kD>(i * kBlock);
    }
    for (int i = 0; i < nodes(); ++i) {
      const int c = component_[at(i)];
      v.template segment<kD>(i * kBlock) -=
          known_.template middleRows<kD>(i * kBlock) * along.col(c) / count[c];
    }
    return v;
  }

  std::vector<int> component_;
  int components_ = 0;
  std::vector<NodeBlock<kBlock>> blocks_;
  Eigen::Matrix<double, Eigen::Dynamic, kD> known_;
  std::optional<SparseFactor<kBlock>> factor_;
  double scale_ = 0.0;
  double eta_ = 0.0;
};

}  // namespace

template <class Pose>
Certificate certify(const PoseGraph<Pose>& graph, const CertificateOptions& options) {
  constexpr int kD = kDimension<Pose>;
  const IsotropicProblem<Pose> problem = isotropic_problem(graph);
  const StationaryPoint<Pose> point = polish(graph, problem);
  Certificate certificate;
  certificate.anisotropy = std::max(1.0 - problem.least_part, 1.0 - 1.0 / problem.most_part);
  certificate.problem = certificate.anisotropy <= options.max_anisotropy
                            ? CertifiedProblem::own
                            : CertifiedProblem::isotropic;
  certificate.objective = certificate.gap = point.objective;  // f >= 0
  certificate.stationary = point.converged;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    certificate.moved = std::max(certificate.moved, distance(graph.nodes[i], point.poses[i]));
    certificate.turned = std::max(certificate.turned, turn_between(graph.nodes[i], point.poses[i]));
  }

  // The least eta of those ten times as large as the one before that leaves S + eta positive, then
  // the eigenvalue itself.
  RotationHessian<Pose> hessian(graph, point);
  const double per_eta = kD * static_cast<double>(graph.nodes.size());
  const double allowed =
      options.max_gap *
      (point.objective + kDegreesOfFreedom<Pose> * static_cast<double>(graph.constraints.size()));
  double eta = 1e-3 * allowed / per_eta;
  while (!hessian.factorize(eta) && eta < hessian.scale()) eta *= 10.0;
  if (eta < hessian.scale()) {
    certificate.min_eigenvalue = hessian.min_eigenvalue();
    const double closer = -certificate.min_eigenvalue * (1.0 + 1e-4);
    if (closer > 0.0 && closer < eta && hessian.factorize(closer)) eta = closer;
    certificate.gap = std::min(certificate.gap, eta * per_eta);
  }
  certificate.lower_bound = certificate.objective - certificate.gap;
  certificate.own_lower_bound = problem.least_part * certificate.lower_bound;
  certificate.certified = certificate.stationary && certificate.gap <= allowed;
  return certificate;
}

template Certificate certify(const PoseGraph<Pose2>&, const CertificateOptions&);
template Certificate certify(const PoseGraph<Pose3>&, const CertificateOptions&);

}  // namespace mapbed
