#include "algorithms/pose_graph/constraint_error.h"

#include <gtest/gtest.h>

#include "algorithms/pose_graph/testing/made_graphs.h"

namespace mapbed {
namespace {

template <class Pose>
class ConstraintError : public ::testing::Test {};
using Poses = ::testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(ConstraintError, Poses);

TYPED_TEST(ConstraintError, VanishesWhereTheMeasurementIsTrue) {
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const auto a = random_pose<TypeParam>(rng);
    const auto b = random_pose<TypeParam>(rng);
    EXPECT_LT(constraint_error(motion_between(a, b), a, b).norm(), 1e-13);
  }
}

TYPED_TEST(ConstraintError, DerivativesAreThoseOfDifferences) {
  Rng rng(2);
  constexpr double kStep = 1e-6;  // central differences are exact to about kStep^2
  for (int i = 0; i < 100; ++i) {
    const auto z = random_pose<TypeParam>(rng);
    const auto a = random_pose<TypeParam>(rng);
    // Not half a turn off: there the angle, and the sign of the quaternion, jump.
    const auto b = a * z * moved(TypeParam{}, PoseTangent<TypeParam>::Constant(0.3));
    const LinearError<TypeParam> linear = linear_error(z, a, b);
    EXPECT_LT((linear.error - constraint_error(z, a, b)).norm(), 1e-13);
    for (int k = 0; k < kDegreesOfFreedom<TypeParam>; ++k) {
      const PoseTangent<TypeParam> step = kStep * PoseTangent<TypeParam>::Unit(k);
      const PoseTangent<TypeParam> by_from =
          (constraint_error(z, moved(a, step), b) - constraint_error(z, moved(a, -step), b)) /
          (2.0 * kStep);
      const PoseTangent<TypeParam> by_to =
          (constraint_error(z, a, moved(b, step)) - constraint_error(z, a, moved(b, -step))) /
          (2.0 * kStep);
      EXPECT_LT((linear.by_from.col(k) - by_from).norm(), 1e-8);
      EXPECT_LT((linear.by_to.col(k) - by_to).norm(), 1e-8);
    }
  }
}

TEST(ConstraintErrorInThePlane, IsSeenFromTheMeasuredPose) {
  // The node is 1 m further along y than it was measured; the measured pose looks along y.
  const Pose2 measured{2.0, 0.0, kPi / 2};
  const PoseTangent<Pose2> error = constraint_error(measured, Pose2{}, {2.0, 1.0, kPi / 2 + 0.1});
  EXPECT_NEAR(error.x(), 1.0, 1e-15);
  EXPECT_NEAR(error.y(), 0.0, 1e-15);
  EXPECT_NEAR(error.z(), 0.1, 1e-15);
}

TEST(ConstraintErrorInThePlane, TakesTheShortWayRound) {
  const PoseTangent<Pose2> error =
      constraint_error({0.0, 0.0, kPi - 0.1}, Pose2{}, {0.0, 0.0, -kPi + 0.1});
  EXPECT_NEAR(error.z(), 0.2, 1e-14);
}

TEST(ConstraintErrorInSpace, IsTheSineOfHalfTheAngleWhateverTheQuaternionsSign) {
  Pose3 to;
  to.rotation = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY());
  for (const double sign : {1.0, -1.0}) {
    Pose3 other = to;
    other.rotation.coeffs() *= sign;
    const PoseTangent<Pose3> error = constraint_error(Pose3{}, Pose3{}, other);
    EXPECT_NEAR(error[4], std::sin(0.3), 1e-15);
    EXPECT_NEAR(error.norm(), std::sin(0.3), 1e-15);
  }
}

TEST(MovedPose, TurnsByTheRotationVectorInItsOwnFrame) {
  Rng rng(3);
  const Pose3 pose = random_pose3(rng);
  for (const double angle : {1e-7, 1e-3, 1.0, 3.0}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -2.0) / 3.0;
    PoseTangent<Pose3> step;
    step << 1.0, 2.0, 3.0, angle * axis;
    const Pose3 result = moved(pose, step);
    EXPECT_LT((result.position - pose.position - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 1e-15);
    const Eigen::Matrix3d turn = (pose.rotation.conjugate() * result.rotation).toRotationMatrix();
    EXPECT_LT((turn - Eigen::AngleAxisd(angle, axis).toRotationMatrix()).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace mapbed
