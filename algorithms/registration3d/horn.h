#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose3.h"

namespace mapbed {

// Rotation matrix of a unit quaternion q0 + q1 i + q2 j + q3 k, (2.27) with the signs corrected.
Eigen::Matrix3d rotation_matrix(const Eigen::Vector4d& q);

struct ClosedFormRegistration {
  Pose3 x_from_p;
  double mean_squared_error = 0.0;  // [m^2] of |x_i - (R p_i + t)|
  bool unique = false;  // false: some other rotation fits as well (fewer than three points, all on
                        // one line, mirror images); x_from_p is one of the best
};

// The rigid motion that brings the points p_i onto their partners x_i with least squared error,
// (2.22)-(2.28), after Horn (1987): the rotation is the eigenvector of the largest eigenvalue of a
// symmetric 4 x 4 matrix N. Corrected are: what is maximised, sum x_i'^T R p_i' in (2.25); the
// differences in N, with S_ab = sum p'_a x'_b; and t = mu_x - R mu_p in (2.23) and (2.28).
// As many points p as x, one or more.
ClosedFormRegistration register_in_closed_form(const std::vector<Eigen::Vector3d>& p,
                                               const std::vector<Eigen::Vector3d>& x);

}  // namespace mapbed
