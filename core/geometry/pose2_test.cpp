#include "core/geometry/pose2.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

TEST(Pose2, TimesItsInverseIsTheIdentity) {
  const Pose2 pose{1.5, -2.0, 2.9};
  EXPECT_THAT(pose * inverse(pose), IsNear(Pose2{}, Tolerance{1e-12, 1e-12}));
  EXPECT_THAT(inverse(pose) * pose, IsNear(Pose2{}, Tolerance{1e-12, 1e-12}));
}

TEST(Pose2, TakesAPointToTheOuterFrame) {
  const Pose2 map_from_robot{1.0, 2.0, kPi / 2};
  EXPECT_LT((map_from_robot * Eigen::Vector2d(1.0, 0.0) - Eigen::Vector2d(1.0, 3.0)).norm(), 1e-12);
}

TEST(Pose2, HeadingsWrapInProducts) {
  const Pose2 product = Pose2{0, 0, radians(170)} * Pose2{0, 0, radians(30)};
  EXPECT_NEAR(product.theta, radians(-160), 1e-12);
}

TEST(Pose2, InterpolationCrossesTheWrapTheShortWay) {
  const Pose2 half = interpolate({0, 0, radians(170)}, {0, 0, radians(-170)}, 0.5);
  EXPECT_NEAR(std::abs(half.theta), kPi, 1e-12);
}

TEST(Angle, NormalizedAnglesLieInTheHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(normalized_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(normalized_angle(kPi), kPi);
  EXPECT_NEAR(normalized_angle(7 * kPi / 2), -kPi / 2, 1e-12);
}

}  // namespace
}  // namespace mapbed
