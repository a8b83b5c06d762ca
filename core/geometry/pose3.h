#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/pose2.h"

namespace mapbed {

// A rigid motion in space. Named target_from_source, as Pose2.
struct Pose3 {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            // [m]
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // of unit length

  // A rotation and its negative are the same pose but not equal here.
  friend bool operator==(const Pose3& a, const Pose3& b) {
    return a.position == b.position && a.rotation.coeffs() == b.rotation.coeffs();
  }
};

Pose3 operator*(const Pose3& a_from_b, const Pose3& b_from_c);
Eigen::Vector3d operator*(const Pose3& a_from_b, const Eigen::Vector3d& point_in_b);
Pose3 inverse(const Pose3& a_from_b);

// The motion from one pose to another, both in the same frame: inverse(from) * to.
Pose3 motion_between(const Pose3& world_from_a, const Pose3& world_from_b);

// On the way from a (at fraction 0) to b (at fraction 1): position linearly, rotation at constant
// rate the short way round. Extrapolates outside [0, 1].
Pose3 interpolate(const Pose3& a, const Pose3& b, double fraction);

// Upright at a height: x forward, y left, z up; turned about the vertical only.
Pose3 upright(const Pose2& pose, double z = 0.0);
// The place and heading in the plan: heading of the x axis; height and tilt are lost.
Pose2 planar(const Pose3& pose);
// Turned about z (yaw), then y (pitch; positive: nose down), then x (roll). All [rad].
Eigen::Quaterniond rotation_of(double yaw, double pitch, double roll);

double distance(const Pose3& a, const Pose3& b);  // [m] between the positions
double angle_between(const Pose3& a,
                     const Pose3& b);  // [rad] of the rotation from one to the other
bool is_finite(const Pose3& pose);

}  // namespace mapbed
