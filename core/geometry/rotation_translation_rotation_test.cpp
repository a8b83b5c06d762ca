#include "core/geometry/rotation_translation_rotation.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr double kLeast = 0.01;  // [m]

TEST(RotationTranslationRotation, TakesAMotionApart) {
  const RotationTranslationRotation parts = decomposed({1.0, 1.0, radians(60)}, kLeast);
  EXPECT_NEAR(parts.first_rotation, radians(45), 1e-12);
  EXPECT_NEAR(parts.translation, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(parts.second_rotation, radians(15), 1e-12);
}

TEST(RotationTranslationRotation, BackwardsIsANegativeTranslationAndNoHalfTurn) {
  const RotationTranslationRotation parts = decomposed({-1.0, 0.1, 0.0}, kLeast);
  EXPECT_LT(parts.translation, -1.0);
  EXPECT_NEAR(parts.first_rotation, -std::atan(0.1), 1e-12);
}

TEST(RotationTranslationRotation, OnTheSpotItIsOneRotation) {
  const RotationTranslationRotation parts = decomposed({-0.003, 0.004, 1.0}, kLeast);
  EXPECT_EQ(parts.first_rotation, 0.0);
  EXPECT_EQ(parts.translation, -0.003);
  EXPECT_EQ(parts.second_rotation, 1.0);
}

TEST(RotationTranslationRotation, PutTogetherIsTheMotionAgain) {
  for (const Pose2 motion : {Pose2{0.5, 0.1, 0.3}, Pose2{-0.5, 0.1, 3.0}, Pose2{0, -0.2, -2.0}}) {
    EXPECT_THAT(composed(decomposed(motion, kLeast)), IsNear(motion, Tolerance{1e-12, 1e-12}));
  }
}

}  // namespace
}  // namespace mapbed
