#include "algorithms/localization/pose_answer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

TEST(PoseAnswer, IsTheMeanAboutThePlaceThatMostOfTheBeliefIsAbout) {
  const std::vector<Pose2> poses{{0.1, 0.1, 0.1}, {0.3, 0.1, 0.1}, {7.0, 3.0, 0.0}};
  const std::vector<double> weights{0.45, 0.15, 0.4};
  const PoseAnswer answer = answer_of(poses, weights, {});
  EXPECT_THAT(answer.mean, IsNear({0.15, 0.1, 0.1}, {1e-9, 1e-9}));
  EXPECT_NEAR(answer.weight, 0.6, 1e-12);
  // 0.75 at -0.05 m and 0.25 at 0.15 m.
  EXPECT_NEAR(answer.covariance(0, 0), 0.75 * 0.0025 + 0.25 * 0.0225, 1e-12);
  EXPECT_NEAR(answer.largest_sigma(), std::sqrt(0.0075), 1e-9);
}

TEST(PoseAnswer, HeadingsOnBothSidesOfTheHalfTurnAreOne) {
  const std::vector<Pose2> poses{{0.1, 0.1, kPi - 0.1}, {0.1, 0.1, -kPi + 0.1}};
  const PoseAnswer answer = answer_of(poses, std::vector<double>{0.5, 0.5}, {});
  EXPECT_NEAR(answer.weight, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(answer.mean.theta), kPi, 1e-9);
  EXPECT_NEAR(answer.covariance(2, 2), 0.01, 1e-9);
}

TEST(PoseAnswer, PlacesThatTouchAreOneAndThoseApartAreNot) {
  const PoseBinOptions bins{.side = 1.0, .turns = 4};
  const std::vector<Pose2> poses{{0.5, 0.5, 0.1}, {1.5, 1.5, 0.1}, {3.5, 1.5, 0.1}};
  EXPECT_EQ(touching_groups(poses, bins), (std::vector<std::size_t>{0, 0, 1}));
  EXPECT_EQ(occupied_bins(poses, bins), 3u);
}

}  // namespace
}  // namespace mapbed
