#include "algorithms/pose_graph/relative_covariance.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "algorithms/pose_graph/constraint_error.h"
#include "algorithms/pose_graph/graph_optimizer.h"
#include "algorithms/pose_graph/testing/made_graphs.h"

namespace mapbed {
namespace {

template <class Pose>
class RelativeCovariance : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(RelativeCovariance, Poses);

TYPED_TEST(RelativeCovariance, OfNeighboursInAChainIsThatOfTheirConstraint) {
  Rng rng(13);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 10);
  std::erase_if(graph.constraints, [](const auto& c) { return c.closes_loop; });
  const RelativeCovariances<TypeParam> covariances(graph);
  // Of (position, heading) of the error, seen from the measured pose; the sine of half the angle.
  const auto& constraint = graph.constraints[4];
  PoseInformation<TypeParam> turn = PoseInformation<TypeParam>::Identity();
  if constexpr (kDegreesOfFreedom<TypeParam> == 3) {
    turn.template topLeftCorner<2, 2>() =
        Eigen::Rotation2Dd(constraint.from_from_to.theta).toRotationMatrix();
  } else {
    turn.template topLeftCorner<3, 3>() = constraint.from_from_to.rotation.toRotationMatrix();
    turn.template bottomRightCorner<3, 3>() *= 2.0;
  }
  const PoseInformation<TypeParam> expected =
      turn * constraint.information.inverse() * turn.transpose();
  const auto found = covariances.between(4, 5);
  ASSERT_TRUE(found);
  EXPECT_LT((*found - expected).norm(), 1e-9 * expected.norm());
}

// Graphs measured again and again, each time with other noise, scatter as it says.
TYPED_TEST(RelativeCovariance, IsHowOptimaScatter) {
  Rng rng(14);
  const PoseGraph<TypeParam> truth = ring_without_noise<TypeParam>(rng, 15);
  PoseGraph<TypeParam> sharp = truth;
  for (auto& c : sharp.constraints) c.information *= 1e4;  // so that it is all but linear
  const auto expected = *RelativeCovariances<TypeParam>(sharp).between(3, 11);

  constexpr int kRounds = 2000;
  PoseInformation<TypeParam> scatter = PoseInformation<TypeParam>::Zero();
  const TypeParam true_motion = motion_between(truth.nodes[3], truth.nodes[11]);
  for (int round = 0; round < kRounds; ++round) {
    PoseGraph<TypeParam> graph = sharp;
    for (auto& c : graph.constraints) {
      PoseTangent<TypeParam> noise;
      for (double& entry : noise) entry = rng.normal(0.0, 1.0);
      noise = c.information.llt().matrixU().solve(noise);
      if constexpr (kDegreesOfFreedom<TypeParam> == 6) noise.template tail<3>() *= 2.0;
      c.from_from_to = c.from_from_to * moved(TypeParam{}, noise);
    }
    const auto optimum = optimize(graph);
    const TypeParam motion = motion_between(optimum.poses[3], optimum.poses[11]);
    PoseTangent<TypeParam> off;
    if constexpr (kDegreesOfFreedom<TypeParam> == 3) {
      off << motion.x - true_motion.x, motion.y - true_motion.y,
          angle_difference(true_motion.theta, motion.theta);
    } else {
      off.template head<3>() = motion.position - true_motion.position;
      off.template tail<3>() =
          2.0 * constraint_error(true_motion, Pose3{}, motion).template tail<3>();
    }
    scatter += off * off.transpose() / kRounds;
  }
  // A variance of n draws is known to sqrt(2 / n) = 3 %; six times that over all entries.
  EXPECT_LT((scatter - expected).norm(), 6.0 * std::sqrt(2.0 / kRounds) * expected.norm());
}

TYPED_TEST(RelativeCovariance, IsNoneAcrossComponentsAndZeroToItself) {
  Rng rng(15);
  PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 10);
  graph.nodes.push_back(TypeParam{});
  const RelativeCovariances<TypeParam> covariances(graph);
  EXPECT_FALSE(covariances.between(3, 10));
  ASSERT_TRUE(covariances.between(3, 3));
  EXPECT_EQ(covariances.between(3, 3)->norm(), 0.0);
}

TYPED_TEST(RelativeCovariance, CountsWeights) {
  Rng rng(16);
  const PoseGraph<TypeParam> graph = ring_without_noise<TypeParam>(rng, 12);
  const auto once = *RelativeCovariances<TypeParam>(graph).between(2, 9);
  const std::vector<double> weights(graph.constraints.size(), 4.0);
  const auto four_times = *RelativeCovariances<TypeParam>(graph, weights).between(2, 9);
  EXPECT_LT((once - 4.0 * four_times).norm(), 1e-9 * once.norm());
}

}  // namespace
}  // namespace mapbed
