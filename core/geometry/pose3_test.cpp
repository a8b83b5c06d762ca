#include "core/geometry/pose3.h"

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kRounding = 1e-12;  // a few operations on numbers of size 10

Pose3 any_pose(Rng& rng) {
  return {{rng.uniform(-10, 10), rng.uniform(-10, 10), rng.uniform(-10, 10)},
          rotation_of(rng.uniform(-3, 3), rng.uniform(-1.5, 1.5), rng.uniform(-3, 3))};
}

void expect_same(const Pose3& a, const Pose3& b) {
  EXPECT_NEAR(distance(a, b), 0.0, kRounding);
  EXPECT_NEAR(angle_between(a, b), 0.0, 1e-7);  // angularDistance loses half the digits near zero
}

TEST(Pose3, TimesItsInverseIsTheIdentity) {
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const Pose3 pose = any_pose(rng);
    expect_same(pose * inverse(pose), Pose3{});
    expect_same(inverse(pose) * pose, Pose3{});
  }
}

TEST(Pose3, ComposesAsItsPointsDo) {
  Rng rng(2);
  for (int i = 0; i < 100; ++i) {
    const Pose3 a = any_pose(rng);
    const Pose3 b = any_pose(rng);
    const Eigen::Vector3d point(1.0, -2.0, 3.0);
    EXPECT_LT(((a * b) * point - a * (b * point)).norm(), kRounding);
  }
}

TEST(Pose3, OfThePlaneMovesAsPose2Does) {
  const Pose2 a{1.0, 2.0, 0.7};
  const Pose2 b{-0.5, 0.3, 2.9};
  const Pose2 product = planar(upright(a, 1.0) * upright(b, 0.5));
  EXPECT_NEAR(distance(product, a * b), 0.0, kRounding);
  EXPECT_NEAR(angle_difference(product.theta, (a * b).theta), 0.0, kRounding);
  EXPECT_NEAR((upright(a, 1.0) * upright(b, 0.5)).position.z(), 1.5, kRounding);
}

TEST(Pose3, PitchesItsNoseDown) {
  const Pose3 pose{Eigen::Vector3d::Zero(), rotation_of(0.0, radians(30), 0.0)};
  const Eigen::Vector3d nose = pose * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(nose.z(), -0.5, kRounding);
}

TEST(Pose3, IsHalfWayTurnedHalfWayThere) {
  const Pose3 from = upright({0.0, 0.0, radians(170)});
  const Pose3 to = upright({2.0, 0.0, radians(-170)});
  expect_same(interpolate(from, to, 0.5), upright({1.0, 0.0, radians(180)}));
  expect_same(interpolate(from, to, 0.0), from);
  expect_same(interpolate(from, to, 1.0), to);
}

}  // namespace
}  // namespace mapbed
