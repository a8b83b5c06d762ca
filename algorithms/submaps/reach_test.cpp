#include "algorithms/submaps/reach.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// Each node a metre ahead of the one before, and turned by `turn`.
PoseGraph<Pose2> chain(int nodes, double turn, const Eigen::Vector3d& sigmas) {
  PoseGraph<Pose2> graph;
  const Pose2 step{1.0, 0.0, turn};
  graph.nodes.push_back({});
  for (int i = 1; i < nodes; ++i) {
    graph.nodes.push_back(graph.nodes.back() * step);
    graph.constraints.push_back({.from = i - 1,
                                 .to = i,
                                 .from_from_to = step,
                                 .information = sigmas.cwiseInverse().cwiseAbs2().asDiagonal()});
  }
  return graph;
}

TEST(Reach, PositionsOfAStraightChainErrAsItsSteps) {
  const PoseGraph<Pose2> graph = chain(5, 0.0, {0.1, 0.2, 1e-9});
  const Reach reach = reach_of(graph, {}, 4)[0];
  ASSERT_TRUE(reach.reached);
  EXPECT_NEAR(reach.covariance(0, 0), 4 * 0.01, 1e-9);
  EXPECT_NEAR(reach.covariance(1, 1), 4 * 0.04, 1e-9);
}

// The error of the heading of step k turns the 4 - k metres after it: 3^2 + 2^2 + 1^2 + 0.
TEST(Reach, HeadingsMoveWhatComesAfterThem) {
  const PoseGraph<Pose2> graph = chain(5, 0.0, {1e-9, 1e-9, 0.01});
  const Reach reach = reach_of(graph, {}, 4)[0];
  EXPECT_NEAR(reach.covariance(1, 1), 14 * 1e-4, 1e-9);
  EXPECT_NEAR(reach.covariance(0, 0), 0.0, 1e-9);
  EXPECT_NEAR(reach.covariance(2, 2), 4 * 1e-4, 1e-9);
}

// By differences: the last pose as a function of each step's error, both ways along the chain.
TEST(Reach, IsThatOfTheErrorsOfAllStepsOnACurve) {
  const Eigen::Vector3d sigmas(0.1, 0.05, 0.02);
  const PoseGraph<Pose2> graph = chain(6, 0.5, sigmas);
  for (const auto& [seen, seer] : {std::pair{5, 0}, std::pair{0, 5}, std::pair{4, 1}}) {
    const auto seen_with = [&](std::size_t step, const Pose2& error) {
      Pose2 pose;
      for (int i = std::min(seen, seer); i < std::max(seen, seer); ++i) {
        const auto k = static_cast<std::size_t>(i);
        pose = pose * graph.constraints[k].from_from_to * (k == step ? error : Pose2{});
      }
      return seen > seer ? pose : inverse(pose);
    };
    Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
    const double h = 1e-6;
    for (std::size_t k = 0; k < graph.constraints.size(); ++k) {
      if (static_cast<int>(k) < std::min(seen, seer) || static_cast<int>(k) >= std::max(seen, seer))
        continue;
      const Pose2 errors[3] = {{h, 0, 0}, {0, h, 0}, {0, 0, h}};
      for (int d = 0; d < 3; ++d) {
        const Pose2 moved = seen_with(k, errors[d]), there = seen_with(k, {});
        const Eigen::Vector3d change = Eigen::Vector3d(moved.x - there.x, moved.y - there.y,
                                                       angle_difference(there.theta, moved.theta)) /
                                       h * sigmas[d];
        expected += change * change.transpose();
      }
    }
    const Reach reach = reach_of(graph, {}, seen)[static_cast<std::size_t>(seer)];
    EXPECT_TRUE(reach.covariance.isApprox(expected, 1e-4)) << reach.covariance << "\n\n"
                                                           << expected;
  }
}

TEST(Reach, GoesByTheSurestWay) {
  PoseGraph<Pose2> graph = chain(10, 0.0, {0.1, 0.1, 0.01});
  const double before = reach_of(graph, {}, 9)[0].covariance(0, 0);
  graph.constraints.push_back({.from = 0,
                               .to = 9,
                               .from_from_to = {9.0, 0.0, 0.0},
                               .information = 1e4 * Eigen::Matrix3d::Identity(),
                               .closes_loop = true});
  EXPECT_NEAR(reach_of(graph, {}, 9)[0].covariance(0, 0), 1e-4, 1e-9);
  std::vector<double> weights(graph.constraints.size(), 1.0);
  weights.back() = 0.0;  // not believed
  EXPECT_NEAR(reach_of(graph, weights, 9)[0].covariance(0, 0), before, 1e-9);
}

TEST(Reach, TellsWhatNoConstraintLeadsTo) {
  PoseGraph<Pose2> graph = chain(3, 0.0, {0.1, 0.1, 0.01});
  graph.nodes.push_back({});
  const std::vector<Reach> reach = reach_of(graph, {}, 0);
  EXPECT_TRUE(reach[2].reached);
  EXPECT_FALSE(reach[3].reached);
}

}  // namespace
}  // namespace mapbed
