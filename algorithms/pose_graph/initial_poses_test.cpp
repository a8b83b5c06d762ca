#include "algorithms/pose_graph/initial_poses.h"

#include <gtest/gtest.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/position_equations.h"
#include "algorithms/pose_graph/testing/made_graphs.h"

namespace mapbed {
namespace {

template <class Pose>
class InitialPoses : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(InitialPoses, Poses);

double largest_error(const auto& a, const auto& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, constraint_error({}, a[i], b[i]).norm());
  }
  return largest;
}

template <class Pose>
double chi2_of(const PoseGraph<Pose>& graph, const std::vector<Pose>& nodes) {
  double sum = 0.0;
  for (const auto& constraint : graph.constraints) sum += chi_square_of(constraint, nodes);
  return sum;
}

// Two rings, the first held at its own pose of node 4, the second, like both, unknown otherwise.
template <class Pose>
PoseGraph<Pose> two_rings(Rng& rng) {
  PoseGraph<Pose> graph = ring_without_noise<Pose>(rng, 30);
  const PoseGraph<Pose> other = ring_without_noise<Pose>(rng, 20);
  for (auto constraint : other.constraints) {
    constraint.from += 30;
    constraint.to += 30;
    graph.constraints.push_back(constraint);
  }
  graph.nodes.insert(graph.nodes.end(), other.nodes.begin(), other.nodes.end());
  graph.held = {4};
  return graph;
}

TYPED_TEST(InitialPoses, AreTrueWhereMeasurementsAre) {
  Rng rng(30);
  PoseGraph<TypeParam> graph = two_rings<TypeParam>(rng);
  const std::vector<TypeParam> truth = graph.nodes;
  for (std::size_t node = 0; node < truth.size(); ++node) {
    if (node != 4 && node != 30) graph.nodes[node] = TypeParam{};
  }
  EXPECT_LT(largest_error(spanning_tree_poses(graph), truth), 1e-12);
  EXPECT_LT(largest_error(chordal_poses(graph), truth), 1e-9);
}

// The tree adds errors up along its branches, the chordal start spreads them.
TYPED_TEST(InitialPoses, OfTheChordalStartAreNearerTheOptimumThanATrees) {
  Rng rng(31);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 80, 2);
  for (auto& constraint : graph.constraints) {
    PoseTangent<TypeParam> noise;
    for (double& entry : noise) entry = rng.normal(0.0, 0.1);
    constraint.from_from_to = moved(constraint.from_from_to, noise);
  }
  const double best = optimize(graph).chi2_after;
  const double chordal = chi2_of(graph, chordal_poses(graph));
  EXPECT_GE(chordal, best);
  EXPECT_LT(chordal, 0.1 * chi2_of(graph, spanning_tree_poses(graph)));
}

TYPED_TEST(InitialPoses, AreLeftWhereNothingIsKnown) {
  Rng rng(32);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 10);
  for (auto& constraint : graph.constraints) constraint.information.setZero();
  EXPECT_LT(largest_error(chordal_poses(graph), spanning_tree_poses(graph)), 1e-15);
  EXPECT_TRUE(chordal_poses(PoseGraph<TypeParam>{}).empty());
}

// Of least cost: no position that is moved lowers it, however they began.
TYPED_TEST(InitialPoses, PositionsAreTheBestForTheRotations) {
  Rng rng(33);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 25);
  for (auto& node : graph.nodes) node = node * random_pose<TypeParam>(rng, 100.0);
  std::vector<double> weights;
  for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
    weights.push_back(rng.uniform(0.5, 2.0));
    graph.constraints[i].information *= weights.back();
  }
  PoseGraph<TypeParam> unweighted = graph;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    unweighted.constraints[i].information /= weights[i];
  }
  const auto best = PositionEquations<TypeParam>(graph).solve(unweighted, graph.nodes, weights);
  for (std::size_t node = 1; node < best.size(); ++node) {
    for (int k = 0; k < kDegreesOfFreedom<TypeParam> / 2 + 1; ++k) {
      if (k == 2 && kDegreesOfFreedom<TypeParam> == 3) continue;
      if (k == 3) continue;
      for (const double size : {0.1, -0.1}) {
        auto other = best;
        other[node] = moved(other[node], size * PoseTangent<TypeParam>::Unit(k));
        EXPECT_GT(chi2_of(graph, other), chi2_of(graph, best));
      }
    }
  }
}

}  // namespace
}  // namespace mapbed
