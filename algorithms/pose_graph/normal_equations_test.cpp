#include "algorithms/pose_graph/normal_equations.h"

#include <gtest/gtest.h>

#include "algorithms/pose_graph/testing/made_graphs.h"

namespace mapbed {
namespace {

template <class Pose>
class NormalEquationsOf : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(NormalEquationsOf, Poses);

// The same, dense.
template <class Pose>
struct DenseEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient;
};

template <class Pose>
DenseEquations<Pose> dense(const PoseGraph<Pose>& graph, const std::vector<double>& weights,
                           const NormalEquations<Pose>& equations) {
  constexpr int kSize = kDegreesOfFreedom<Pose>;
  DenseEquations<Pose> result{Eigen::MatrixXd::Zero(equations.size(), equations.size()),
                              Eigen::VectorXd::Zero(equations.size())};
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    const PoseConstraint<Pose>& c = graph.constraints[i];
    const LinearError<Pose> linear =
        linear_error(c.from_from_to, graph.nodes[static_cast<std::size_t>(c.from)],
                     graph.nodes[static_cast<std::size_t>(c.to)]);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(kSize, equations.size());
    const int a = equations.offset_of(c.from);
    const int b = equations.offset_of(c.to);
    if (a >= 0) jacobian.middleCols<kSize>(a) += linear.by_from;
    if (b >= 0) jacobian.middleCols<kSize>(b) += linear.by_to;
    result.matrix += weights[i] * jacobian.transpose() * c.information * jacobian;
    result.gradient += weights[i] * jacobian.transpose() * c.information * linear.error;
  }
  return result;
}

template <class Pose>
PoseGraph<Pose> shaken_ring(Rng& rng, int count) {
  PoseGraph<Pose> graph = ring_without_noise<Pose>(rng, count);
  for (Pose& node : graph.nodes) {
    PoseTangent<Pose> step;
    for (double& entry : step) entry = rng.normal(0.0, 0.3);
    node = moved(node, step);
  }
  graph.constraints.push_back(graph.constraints.front());  // twice, counted twice
  graph.constraints.push_back(graph.constraints[2]);
  std::swap(graph.constraints.back().from, graph.constraints.back().to);
  return graph;
}

TYPED_TEST(NormalEquationsOf, AGraphAreThoseOfTheDenseSums) {
  Rng rng(4);
  PoseGraph<TypeParam> graph = shaken_ring<TypeParam>(rng, 40);
  graph.held = {5, 6};
  std::vector<double> weights;
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    weights.push_back(i % 5 == 0 ? 0.0 : rng.uniform(0.1, 2.0));
  }
  NormalEquations<TypeParam> equations(graph);
  EXPECT_EQ(equations.size(), 38 * kDegreesOfFreedom<TypeParam>);
  EXPECT_EQ(equations.offset_of(5), -1);
  for (int round = 0; round < 2; ++round) {  // filled again in place
    equations.linearize(graph, graph.nodes, weights);
    const DenseEquations<TypeParam> expected = dense(graph, weights, equations);
    const double scale = expected.matrix.norm();
    EXPECT_LT((equations.gradient() - expected.gradient).norm(), 1e-12 * scale);
    for (int i = 0; i < equations.size(); ++i) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(equations.size(), i);
      ASSERT_LT((equations.times(unit) - expected.matrix.col(i)).norm(), 1e-12 * scale);
    }
  }
}

TYPED_TEST(NormalEquationsOf, AGraphAreSolvedAsDenseOnesAreAtAnyDamping) {
  Rng rng(5);
  const PoseGraph<TypeParam> graph = shaken_ring<TypeParam>(rng, 150);
  const std::vector<double> weights(graph.constraints.size(), 1.0);
  NormalEquations<TypeParam> equations(graph);
  equations.linearize(graph, graph.nodes, weights);
  const DenseEquations<TypeParam> expected = dense(graph, weights, equations);
  for (const double damping : {0.0, 0.1, 0.0}) {
    ASSERT_TRUE(equations.factorize(damping));
    Eigen::MatrixXd damped = expected.matrix;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(equations.size(), 3);
    const Eigen::MatrixXd solution = equations.solve(right);
    EXPECT_LT((damped * solution - right).norm(), 1e-9 * right.norm());
  }
}

TYPED_TEST(NormalEquationsOf, ANodeThatNothingFixesAreNotPositiveDefinite) {
  Rng rng(6);
  const PoseGraph<TypeParam> graph = shaken_ring<TypeParam>(rng, 20);
  NormalEquations<TypeParam> equations(graph);
  equations.linearize(graph, graph.nodes, std::vector<double>(graph.constraints.size(), 0.0));
  EXPECT_FALSE(equations.factorize(0.0));
  EXPECT_TRUE(equations.factorize(1.0));
}

}  // namespace
}  // namespace mapbed
