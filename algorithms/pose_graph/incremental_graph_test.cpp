#include "algorithms/pose_graph/incremental_graph.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/testing/made_graphs.h"

namespace mapbed {
namespace {

template <class Pose>
Pose shaken(const Pose& pose, Rng& rng, double sigma) {
  PoseTangent<Pose> step;
  for (double& entry : step) entry = rng.normal(0.0, sigma);
  return moved(pose, step);
}

// Constraints of a graph without noise, odometry first, with noise.
template <class Pose>
std::vector<PoseConstraint<Pose>> noisy_constraints(Rng& rng, int count, double sigma) {
  std::vector<PoseConstraint<Pose>> all = ring_without_noise<Pose>(rng, count).constraints;
  for (auto& c : all) c.from_from_to = shaken(c.from_from_to, rng, sigma);
  return all;
}

// From poses as they are, which are near the optimum.
template <class Pose>
GraphOptimum<Pose> optimum_of(const PoseGraph<Pose>& graph) {
  return optimize(graph, {.algorithm = GraphAlgorithm::gauss_newton, .min_decrease = 1e-15});
}

template <class Pose>
double largest_difference(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Pose difference = motion_between(a[i], b[i]);
    largest = std::max(largest, constraint_error(Pose{}, Pose{}, difference).norm());
  }
  return largest;
}

template <class Pose>
class IncrementalGraphIn : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(IncrementalGraphIn, Poses);

TYPED_TEST(IncrementalGraphIn, AfterAnyChangesItsOptimumIsThatOfTheBatch) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Rng rng(seed);
    constexpr int kNodes = 40;
    const auto all = noisy_constraints<TypeParam>(rng, kNodes, 0.02);
    IncrementalGraph<TypeParam> graph(random_pose<TypeParam>(rng));
    std::size_t next_loop = kNodes - 1;
    std::vector<int> loops;
    for (int step = 0; step < 120; ++step) {
      if (step % 3 == 0 && graph.nodes() < kNodes) {
        graph.add_node(all[static_cast<std::size_t>(graph.nodes() - 1)]);
      } else if (loops.empty() || rng.uniform() < 0.7) {
        // Again and again, so that some are there twice.
        if (next_loop == all.size()) next_loop = kNodes - 1;
        const auto& loop = all[next_loop++];
        if (std::max(loop.from, loop.to) < graph.nodes()) loops.push_back(graph.add(loop));
      } else {
        std::swap(loops[rng.index(loops.size())], loops.back());
        EXPECT_TRUE(graph.remove(loops.back()));
        loops.pop_back();
      }
      if (step % 10 != 9) continue;
      const auto rough = optimum_of(graph.graph());
      EXPECT_LT(largest_difference(graph.poses(), rough.poses), 1e-2);

      auto settled = graph;
      EXPECT_TRUE(settled.converge());
      PoseGraph<TypeParam> shaken_graph = settled.graph();
      for (std::size_t i = 1; i < shaken_graph.nodes.size(); ++i) {
        shaken_graph.nodes[i] = shaken(shaken_graph.nodes[i], rng, 0.01);
      }
      const auto batch = optimum_of(shaken_graph);
      EXPECT_LT(largest_difference(settled.poses(), batch.poses), 1e-6);
      EXPECT_NEAR(settled.objective(), batch.chi2_after, 1e-6 * (1e-3 + batch.chi2_after));
    }
    EXPECT_EQ(graph.nodes(), kNodes);
  }
}

TYPED_TEST(IncrementalGraphIn, AGraphGivenWholeIsTheSameAsItsParts) {
  Rng rng(6);
  const auto all = noisy_constraints<TypeParam>(rng, 20, 0.01);
  IncrementalGraph<TypeParam> parts(random_pose<TypeParam>(rng));
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i < 19) {
      parts.add_node(all[i]);
    } else {
      parts.add(all[i]);
    }
  }
  IncrementalGraph<TypeParam> whole(parts.graph());
  EXPECT_TRUE(whole.remove(20));
  EXPECT_TRUE(parts.remove(20));
  EXPECT_TRUE(whole.converge() && parts.converge());
  EXPECT_LT(largest_difference(whole.poses(), parts.poses()), 1e-8);
  EXPECT_NEAR(whole.log_density(), parts.log_density(), 1e-9 * std::abs(parts.log_density()));
}

TYPED_TEST(IncrementalGraphIn, WhatIsTakenBackLeavesNoTrace) {
  Rng rng(5);
  const auto all = noisy_constraints<TypeParam>(rng, 20, 0.01);
  IncrementalGraph<TypeParam> graph(random_pose<TypeParam>(rng),
                                    {.max_move = 1e9, .max_turn = 1e9});
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (i < 19) {
      graph.add_node(all[i]);
    } else {
      graph.add(all[i]);
    }
  }
  const auto before = graph;
  const int number = graph.add(all.back());
  EXPECT_GT(graph.objective(), before.objective());
  EXPECT_GT(largest_difference(graph.poses(), before.poses()), 1e-4);
  EXPECT_TRUE(graph.remove(number));
  EXPECT_NEAR(graph.objective(), before.objective(), 1e-9 * before.objective());
  EXPECT_LT(largest_difference(graph.poses(), before.poses()), 1e-9);
  EXPECT_NEAR(graph.log_density(), before.log_density(), 1e-9 * std::abs(before.log_density()));
}

// A step in x of 1 m of unit information twice: the optimum has each of a 0.4 m contradiction
// half wrong, J = 2 * 0.2^2.
TEST(IncrementalGraph, TheDensityIsThatOfNormalDistributions) {
  IncrementalGraph<Pose2> graph(Pose2{}, {}, 4.0 * Eigen::Matrix3d::Identity());
  graph.add_node({0, 1, {1.0, 0.0, 0.0}});
  const int number = graph.add({0, 1, {1.4, 0.0, 0.0}});
  EXPECT_NEAR(graph.poses()[1].x, 1.2, 1e-12);
  EXPECT_NEAR(graph.objective(), 0.08, 1e-12);
  EXPECT_NEAR(graph.log_likelihood(), -0.04, 1e-12);
  // ln of 1 / sqrt(2 pi) for each of 9 coordinates, three of which have a sigma of 1/2.
  const double normalizers = -4.5 * std::log(2.0 * kPi) + 3.0 * std::log(2.0);
  EXPECT_NEAR(graph.log_density(), normalizers - 0.04, 1e-12);
  EXPECT_TRUE(graph.remove(number));
  EXPECT_NEAR(graph.log_density(), normalizers + 1.5 * std::log(2.0 * kPi), 1e-12);
}

TEST(IncrementalGraph, TwoMeasurementsAreTwiceTheInformation) {
  IncrementalGraph<Pose2> graph(Pose2{3.0, 4.0, 1.0});
  const Eigen::Matrix3d information = Eigen::Vector3d(4.0, 9.0, 16.0).asDiagonal();
  graph.add_node({0, 1, {1.0, 0.0, 0.5}, information});
  EXPECT_LT((graph.covariance_between(0, 1) - information.inverse()).norm(), 1e-12);
  graph.add({0, 1, {1.0, 0.0, 0.5}, information});
  EXPECT_LT((graph.covariance_between(0, 1) - 0.5 * information.inverse()).norm(), 1e-12);
}

// Of a ring whose last side is measured too long, by so little that no node has to move far, or by
// more.
TEST(IncrementalGraph, LinearisesAnewOnlyWhereNodesMoveFar) {
  const auto linearizations_for = [](double error) {
    IncrementalGraph<Pose2> graph(Pose2{});
    for (int i = 0; i < 3; ++i) graph.add_node({i, i + 1, {1.0, 0.0, kPi / 2}});
    const int before = graph.linearizations();
    graph.add({3, 0, {1.0 + error, 0.0, kPi / 2}});
    return graph.linearizations() - before;
  };
  EXPECT_EQ(linearizations_for(0.02), 0);
  EXPECT_GE(linearizations_for(0.5), 1);
}

TEST(IncrementalGraph, WhatHoldsAPartOfTheGraphAloneIsNotRemoved) {
  IncrementalGraph<Pose2> graph(Pose2{});
  const int first = graph.add_node({0, 1, {1.0, 0.0, 0.0}});
  const int second = graph.add_node({2, 1, {1.0, 0.0, 0.0}});  // the new one is where it is from
  EXPECT_NEAR(graph.poses()[2].x, 0.0, 1e-12);
  EXPECT_FALSE(graph.remove(first));
  EXPECT_FALSE(graph.remove(second));
  graph.add({0, 2, Pose2{}});
  EXPECT_TRUE(graph.remove(first));
  EXPECT_FALSE(graph.remove(second));
  EXPECT_NEAR(graph.poses()[1].x, 1.0, 1e-12);
}

// So much information that nothing is left of the rest's digits beside it.
TEST(IncrementalGraph, AConstraintThatCoversAllOthersCanBeTakenBack) {
  IncrementalGraph<Pose2> graph(Pose2{});
  graph.add_node({0, 1, {1.0, 0.0, 0.0}});
  const int number = graph.add({0, 1, {1.01, 0.0, 0.0}, 1e15 * Eigen::Matrix3d::Identity()});
  EXPECT_NEAR(graph.poses()[1].x, 1.01, 1e-9);
  EXPECT_TRUE(graph.remove(number));
  EXPECT_NEAR(graph.poses()[1].x, 1.0, 1e-9);
  EXPECT_NEAR(graph.objective(), 0.0, 1e-12);
}

TEST(IncrementalGraph, CopiesShareNothing) {
  IncrementalGraph<Pose2> graph(Pose2{});
  graph.add_node({0, 1, {1.0, 0.0, 0.0}});
  IncrementalGraph<Pose2> fork = graph;
  fork.add({0, 1, {1.2, 0.0, 0.0}});
  fork.add_node({1, 2, {1.0, 0.0, 0.0}});
  EXPECT_EQ(graph.nodes(), 2);
  EXPECT_EQ(graph.poses()[1].x, 1.0);
  EXPECT_EQ(graph.objective(), 0.0);
  EXPECT_NEAR(fork.poses()[2].x, 2.1, 1e-12);
}

}  // namespace
}  // namespace mapbed
