#include "algorithms/registration3d/horn.h"

#include <Eigen/Eigenvalues>

#include "core/check.h"

namespace mapbed {
namespace {

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

// q^T N q is the sum of x'^T R(q) p' over the pairs.
Eigen::Matrix4d matrix_n(const Eigen::Matrix3d& s) {
  Eigen::Matrix4d n;
  n(0, 0) = s(0, 0) + s(1, 1) + s(2, 2);
  n(1, 1) = s(0, 0) - s(1, 1) - s(2, 2);
  n(2, 2) = -s(0, 0) + s(1, 1) - s(2, 2);
  n(3, 3) = -s(0, 0) - s(1, 1) + s(2, 2);
  n(0, 1) = n(1, 0) = s(1, 2) - s(2, 1);
  n(0, 2) = n(2, 0) = s(2, 0) - s(0, 2);
  n(0, 3) = n(3, 0) = s(0, 1) - s(1, 0);
  n(1, 2) = n(2, 1) = s(0, 1) + s(1, 0);
  n(1, 3) = n(3, 1) = s(2, 0) + s(0, 2);
  n(2, 3) = n(3, 2) = s(1, 2) + s(2, 1);
  return n;
}

}  // namespace

Eigen::Matrix3d rotation_matrix(const Eigen::Vector4d& q) {
  const double q0 = q[0], q1 = q[1], q2 = q[2], q3 = q[3];
  Eigen::Matrix3d r;
  r << q0 * q0 + q1 * q1 - q2 * q2 - q3 * q3, 2 * (q1 * q2 - q0 * q3), 2 * (q1 * q3 + q0 * q2),  //
      2 * (q1 * q2 + q0 * q3), q0 * q0 - q1 * q1 + q2 * q2 - q3 * q3, 2 * (q2 * q3 - q0 * q1),   //
      2 * (q1 * q3 - q0 * q2), 2 * (q2 * q3 + q0 * q1), q0 * q0 - q1 * q1 - q2 * q2 + q3 * q3;
  return r;
}

ClosedFormRegistration register_in_closed_form(const std::vector<Eigen::Vector3d>& p,
                                               const std::vector<Eigen::Vector3d>& x) {
  CHECK(p.size() == x.size() && !p.empty());
  const Eigen::Vector3d mu_p = mean_of(p);
  const Eigen::Vector3d mu_x = mean_of(x);
  Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) s += (p[i] - mu_p) * (x[i] - mu_x).transpose();

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(matrix_n(s));  // ascending
  const Eigen::Vector4d q = eigen.eigenvectors().col(3);
  const Eigen::Vector4d values = eigen.eigenvalues();

  ClosedFormRegistration result;
  result.x_from_p.rotation = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  result.x_from_p.position = mu_x - rotation_matrix(q) * mu_p;
  result.unique = values[3] - values[2] > 1e-9 * values.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < p.size(); ++i) {
    result.mean_squared_error += (x[i] - result.x_from_p * p[i]).squaredNorm();
  }
  result.mean_squared_error /= static_cast<double>(p.size());
  return result;
}

}  // namespace mapbed
