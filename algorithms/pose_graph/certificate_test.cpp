#include "algorithms/pose_graph/certificate.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/isotropic_problem.h"
#include "algorithms/pose_graph/testing/made_graphs.h"

namespace mapbed {
namespace {

template <class Pose>
Pose turned_about_z(double angle) {
  if constexpr (kDegreesOfFreedom<Pose> == 3) {
    return {0.0, 0.0, normalized_angle(angle)};
  } else {
    return {Eigen::Vector3d::Zero(),
            Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()))};
  }
}

template <class Pose>
Pose shaken(const Pose& pose, Rng& rng, double sigma) {
  PoseTangent<Pose> step;
  for (double& entry : step) entry = rng.normal(0.0, sigma);
  return moved(pose, step);
}

// Of as much information about rotation, in every direction, as about position; in the error's
// coordinates.
template <class Pose>
PoseInformation<Pose> isotropic_information(double position, double rotation) {
  PoseInformation<Pose> information = rotation * PoseInformation<Pose>::Identity();
  information.diagonal().template head<kDimension<Pose>>().setConstant(position);
  return information;
}

// A closed chain of nodes that all stand at the origin, measured with noise.
template <class Pose>
PoseGraph<Pose> ring_at_a_point(Rng& rng, int count, double sigma) {
  PoseGraph<Pose> graph;
  graph.nodes.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    graph.constraints.push_back(
        {i, (i + 1) % count, shaken(Pose{}, rng, sigma), isotropic_information<Pose>(1.0, 100.0)});
  }
  return graph;
}

// The rotations go round once on the way, a part of the whole turn at each node: closed, too, and
// no small change makes it better.
template <class Pose>
PoseGraph<Pose> twisted(PoseGraph<Pose> ring) {
  const auto count = static_cast<double>(ring.nodes.size());
  for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
    ring.nodes[i] =
        ring.nodes[i] * turned_about_z<Pose>(2.0 * kPi * static_cast<double>(i) / count);
  }
  return ring;
}

template <class Pose>
double chi_square_of(const PoseGraph<Pose>& graph) {
  double sum = 0.0;
  for (const auto& c : graph.constraints) sum += chi_square_of(c, graph.nodes);
  return sum;
}

template <class Pose>
class CertificateIn : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(CertificateIn, Poses);

TYPED_TEST(CertificateIn, OfTheTrueOptimumIsGivenAndOfATwistedRingNot) {
  Rng rng(1);
  for (const double sigma : {0.0, 0.02}) {
    const PoseGraph<TypeParam> ring = ring_at_a_point<TypeParam>(rng, 15, sigma);
    const Certificate best = certify(ring);
    EXPECT_TRUE(best.certified);
    EXPECT_TRUE(best.stationary);
    EXPECT_EQ(best.problem, CertifiedProblem::own);
    EXPECT_GT(best.min_eigenvalue, 0.0);
    EXPECT_LE(best.gap, 1e-5 * (best.objective + 15 * kDegreesOfFreedom<TypeParam>));
    if (sigma == 0.0) {
      EXPECT_LT(best.objective, 1e-12);
    }

    const Certificate local = certify(twisted(ring));
    EXPECT_FALSE(local.certified);
    EXPECT_TRUE(local.stationary);
    EXPECT_LT(local.min_eigenvalue, 0.0);
    // 15 errors of 24 degrees, each 100 * angle^2; in space half the angle's sine, squared.
    EXPECT_GT(local.objective, 50.0);
    EXPECT_LE(local.lower_bound, best.objective);
    // It has not left the place where it was. In space any axis of the twist is as good.
    if (kDimension<TypeParam> == 2) {
      EXPECT_LT(local.turned, 0.2);
    }
  }
}

// Whatever frame the map is in, and where two of it are one graph.
TYPED_TEST(CertificateIn, DoesNotDependOnWhereTheMapIs) {
  Rng rng(2);
  const PoseGraph<TypeParam> ring = ring_at_a_point<TypeParam>(rng, 10, 0.02);
  const Certificate here = certify(ring);
  PoseGraph<TypeParam> both = ring;
  const TypeParam there_from_here = random_pose<TypeParam>(rng, 100.0);
  for (const TypeParam& pose : ring.nodes) both.nodes.push_back(there_from_here * pose);
  for (auto c : ring.constraints) {
    c.from += 10;
    c.to += 10;
    both.constraints.push_back(c);
  }
  const Certificate two = certify(both);
  EXPECT_TRUE(two.certified);
  EXPECT_NEAR(two.objective, 2.0 * here.objective, 1e-9);
  EXPECT_NEAR(two.min_eigenvalue, here.min_eigenvalue, 1e-4 * here.min_eigenvalue);
  // The second part twisted: half of it is optimal, the whole is not.
  for (int i = 0; i < 10; ++i) {
    auto& pose = both.nodes[static_cast<std::size_t>(10 + i)];
    pose = pose * turned_about_z<TypeParam>(0.2 * kPi * i);
  }
  EXPECT_FALSE(certify(both).certified);
}

TYPED_TEST(CertificateIn, TheEigenvalueIsThatOfTheDenseMatrix) {
  constexpr int kD = kDimension<TypeParam>;
  constexpr int kBlock = kD + 1;
  Rng rng(3);
  for (const bool is_twisted : {false, true}) {
    PoseGraph<TypeParam> graph = ring_at_a_point<TypeParam>(rng, 9, 0.05);
    if (is_twisted) graph = twisted(graph);
    const int n = 9;
    const auto point = polish(graph, isotropic_problem(graph));
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(n * kBlock, n * kBlock);
    for (const NodeBlock<kBlock>& block : point.hessian) {
      s.template block<kBlock, kBlock>(block.row * kBlock, block.col * kBlock) += block.value;
      if (block.row == block.col) continue;
      s.template block<kBlock, kBlock>(block.col * kBlock, block.row * kBlock) +=
          block.value.transpose();
    }
    // Translations last, that of the first node held.
    std::vector<int> order;
    for (int i = 0; i < n * kBlock; ++i) {
      if (i % kBlock != kD) order.push_back(i);
    }
    for (int i = 1; i < n; ++i) order.push_back(i * kBlock + kD);
    const Eigen::MatrixXd sorted = s(order, order);
    const int r = n * kD;
    const Eigen::MatrixXd of_rotations =
        sorted.topLeftCorner(r, r) -
        sorted.topRightCorner(r, n - 1) *
            sorted.bottomRightCorner(n - 1, n - 1).ldlt().solve(sorted.bottomLeftCorner(n - 1, r));
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(of_rotations).eigenvalues();
    std::vector<double> others(eigenvalues.begin(), eigenvalues.end());
    for (int i = 0; i < kD; ++i) {  // the known ones
      const auto zero = std::min_element(others.begin(), others.end(), [](double a, double b) {
        return std::abs(a) < std::abs(b);
      });
      EXPECT_NEAR(*zero, 0.0, 1e-8);
      others.erase(zero);
    }
    const auto certificate = certify(graph);
    EXPECT_NEAR(certificate.min_eigenvalue, others.front(), 1e-4 * std::abs(others.front()));
    EXPECT_EQ(others.front() < 0.0, is_twisted);
  }
}

// In space exactly; in the plane the chord is shorter than the angle.
TYPED_TEST(CertificateIn, TheIsotropicProblemIsTheGraphsOwnWhereNoiseIsIsotropic) {
  Rng rng(4);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 20);
  for (auto& c : graph.constraints) {
    c.information = isotropic_information<TypeParam>(rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0));
    c.from_from_to = shaken(c.from_from_to, rng, 0.03);
  }
  const auto problem = isotropic_problem(graph);
  EXPECT_NEAR(problem.least_part, 1.0, 1e-12);
  EXPECT_NEAR(problem.most_part, 1.0, 1e-12);
  const auto point = polish(graph, problem);
  EXPECT_TRUE(point.converged);
  graph.nodes = point.poses;
  const double own = chi_square_of(graph);
  const bool is_exact = kDimension<TypeParam> == 3;
  EXPECT_NEAR(point.objective, own, (is_exact ? 1e-12 : 1e-3) * own);
  EXPECT_LE(point.objective, own * (1.0 + 1e-12));
  EXPECT_EQ(certify(graph).problem, CertifiedProblem::own);
}

// By hand: covariances of position diag(1, 1/4), of which the mean is 5/8, and of the heading 1/16.
TEST(IsotropicProblem, WeightsAreOfMeanVariances) {
  const Eigen::Matrix3d plane = Eigen::Vector3d(1.0, 4.0, 16.0).asDiagonal();
  EXPECT_DOUBLE_EQ(isotropic_weights<Pose2>(plane).tau, 8.0 / 5.0);
  EXPECT_DOUBLE_EQ(isotropic_weights<Pose2>(plane).kappa, 8.0);
  // Of the rotation vector four times the variances of the quaternion's vector part: 4, 4 and 1
  // with a sum of 9.
  Eigen::Matrix<double, 6, 6> space = Eigen::Matrix<double, 6, 6>::Identity();
  space(5, 5) = 4.0;
  EXPECT_DOUBLE_EQ(isotropic_weights<Pose3>(space).tau, 1.0);
  EXPECT_DOUBLE_EQ(isotropic_weights<Pose3>(space).kappa, 3.0 / (2.0 * 9.0));
}

TYPED_TEST(CertificateIn, NoisyInformationIsOfTheIsotropicProblemAndItsBoundHoldsForTheGraph) {
  Rng rng(5);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 20);
  for (auto& c : graph.constraints) c.from_from_to = shaken(c.from_from_to, rng, 0.03);
  const auto certificate = certify(graph);
  EXPECT_TRUE(certificate.certified);
  EXPECT_EQ(certificate.problem, CertifiedProblem::isotropic);
  EXPECT_GT(certificate.anisotropy, 0.1);
  EXPECT_GT(certificate.moved, 1e-6);
  graph.nodes = polish(graph, isotropic_problem(graph)).poses;
  EXPECT_LT(certificate.own_lower_bound, chi_square_of(graph));
  EXPECT_GT(certificate.own_lower_bound, 0.0);
}

// Small moves of single nodes from where f is stationary make it no smaller.
TYPED_TEST(CertificateIn, PolishedPosesAreAMinimum) {
  Rng rng(6);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 20);
  for (auto& c : graph.constraints) c.from_from_to = shaken(c.from_from_to, rng, 0.03);
  for (auto& pose : graph.nodes) pose = shaken(pose, rng, 0.2);
  const auto problem = isotropic_problem(graph);
  const auto point = polish(graph, problem);
  EXPECT_TRUE(point.converged);
  for (int i = 0; i < 100; ++i) {
    PoseGraph<TypeParam> other = graph;
    other.nodes = point.poses;
    auto& pose = other.nodes[rng.index(20)];
    pose = shaken(pose, rng, 1e-3);
    other.constraints = graph.constraints;
    // J with isotropic information is f, but for the chord.
    for (auto& c : other.constraints) {
      const auto [kappa, tau] = isotropic_weights<TypeParam>(c.information);
      c.information =
          isotropic_information<TypeParam>(tau, kappa * (kDimension<TypeParam> == 2 ? 2.0 : 8.0));
    }
    PoseGraph<TypeParam> at_minimum = other;
    at_minimum.nodes = point.poses;
    EXPECT_GT(chi_square_of(other), chi_square_of(at_minimum) * (1.0 - 1e-6));
  }
}

// A constraint that says nothing of the heading leaves nothing to certify, and nothing fails.
TEST(Certificate, WithoutInformationOfRotationsNothingIsCertified) {
  PoseGraph<Pose2> graph;
  graph.nodes.resize(3);
  for (int i = 0; i < 2; ++i) {
    graph.constraints.push_back({i, i + 1, Pose2{1.0, 0.0, 0.0}});
    graph.constraints.back().information(2, 2) = 0.0;
  }
  const Certificate certificate = certify(graph);
  EXPECT_EQ(certificate.own_lower_bound, 0.0);
  EXPECT_EQ(certificate.anisotropy, 1.0);
}

}  // namespace
}  // namespace mapbed
