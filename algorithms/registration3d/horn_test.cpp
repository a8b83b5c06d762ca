#include "algorithms/registration3d/horn.h"

#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;
using Points3 = std::vector<Vector3d>;

Vector3d random_point(Rng& rng) {
  return {rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)};
}

Pose3 random_pose(Rng& rng) {
  Vector4d q(rng.normal(), rng.normal(), rng.normal(), rng.normal());
  q.normalize();
  return {random_point(rng), Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
}

Points3 random_points(int count, Rng& rng) {
  Points3 points;
  for (int i = 0; i < count; ++i) points.push_back(random_point(rng));
  return points;
}

Points3 moved(const Points3& points, const Pose3& pose, double sigma, Rng& rng) {
  Points3 result;
  for (const Vector3d& point : points) {
    result.push_back(pose * point + sigma * Vector3d(rng.normal(), rng.normal(), rng.normal()));
  }
  return result;
}

Eigen::Matrix3Xd columns(const Points3& points) {
  Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    matrix.col(static_cast<Eigen::Index>(i)) = points[i];
  return matrix;
}

TEST(Horn, TheQuaternionsMatrixIsThatOfEigen) {  // (2.27)
  Rng rng(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Quaterniond q = random_pose(rng).rotation;
    const Eigen::Matrix3d r = rotation_matrix({q.w(), q.x(), q.y(), q.z()});
    EXPECT_LT((r - q.toRotationMatrix()).norm(), 1e-14);
    EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(r.determinant(), 1.0, 1e-14);
  }
}

TEST(Horn, FindsTheMotionOfPointsWithoutNoise) {  // (2.23), (2.28): t = mu_x - R mu_p
  Rng rng(2);
  for (int i = 0; i < 50; ++i) {
    const Pose3 truth = random_pose(rng);
    const Points3 p = random_points(5, rng);
    const ClosedFormRegistration found = register_in_closed_form(p, moved(p, truth, 0.0, rng));
    EXPECT_TRUE(found.unique);
    EXPECT_LT(distance(found.x_from_p, truth), 1e-12);
    EXPECT_LT(angle_between(found.x_from_p, truth), 1e-7);  // acos near 1 halves the digits
    EXPECT_LT(found.mean_squared_error, 1e-24);
  }
}

TEST(Horn, AgreesWithUmeyamaOnNoisyPoints) {  // (2.25), (2.26), M and N
  Rng rng(3);
  for (int i = 0; i < 50; ++i) {
    const Points3 p = random_points(20, rng);
    const Points3 x = moved(p, random_pose(rng), 0.3, rng);
    const Eigen::Matrix4d umeyama = Eigen::umeyama(columns(p), columns(x), /*with_scaling=*/false);
    const ClosedFormRegistration found = register_in_closed_form(p, x);
    EXPECT_LT((found.x_from_p.rotation.toRotationMatrix() - umeyama.topLeftCorner<3, 3>()).norm(),
              1e-12);
    EXPECT_LT((found.x_from_p.position - umeyama.topRightCorner<3, 1>()).norm(), 1e-12);
  }
}

TEST(Horn, NoSmallMotionFitsBetter) {
  Rng rng(4);
  const Points3 p = random_points(10, rng);
  const Points3 x = moved(p, random_pose(rng), 0.3, rng);
  const ClosedFormRegistration best = register_in_closed_form(p, x);
  for (int i = 0; i < 200; ++i) {
    Pose3 step = random_pose(rng);
    step.position *= 1e-3;
    step.rotation = Eigen::Quaterniond::Identity().slerp(1e-3, step.rotation);
    double error = 0.0;
    for (std::size_t n = 0; n < p.size(); ++n) {
      error += (x[n] - (best.x_from_p * step) * p[n]).squaredNorm() / 10.0;
    }
    EXPECT_GT(error, best.mean_squared_error);
  }
}

TEST(Horn, SaysWhereTheRotationIsNotDetermined) {
  const Points3 one{{1, 2, 3}};
  const Points3 line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  const Points3 triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(register_in_closed_form(one, one).unique);
  EXPECT_FALSE(register_in_closed_form(line, line).unique);
  EXPECT_TRUE(register_in_closed_form(triangle, triangle).unique);
  EXPECT_LT(register_in_closed_form(line, line).mean_squared_error, 1e-24);
}

}  // namespace
}  // namespace mapbed
