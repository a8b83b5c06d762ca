#include "core/geometry/pose3.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {

Pose3 operator*(const Pose3& a_from_b, const Pose3& b_from_c) {
  // Normalised at once: long products would otherwise leave the unit length.
  return {a_from_b * b_from_c.position, (a_from_b.rotation * b_from_c.rotation).normalized()};
}

Eigen::Vector3d operator*(const Pose3& a_from_b, const Eigen::Vector3d& point_in_b) {
  return a_from_b.position + a_from_b.rotation * point_in_b;
}

Pose3 inverse(const Pose3& a_from_b) {
  const Eigen::Quaterniond back = a_from_b.rotation.conjugate();
  return {-(back * a_from_b.position), back};
}

Pose3 motion_between(const Pose3& world_from_a, const Pose3& world_from_b) {
  return inverse(world_from_a) * world_from_b;
}

Pose3 interpolate(const Pose3& a, const Pose3& b, double fraction) {
  Eigen::AngleAxisd turn(a.rotation.conjugate() * b.rotation);
  turn.angle() = normalized_angle(turn.angle()) * fraction;
  return {a.position + fraction * (b.position - a.position), (a.rotation * turn).normalized()};
}

Pose3 upright(const Pose2& pose, double z) {
  return {{pose.x, pose.y, z}, rotation_of(pose.theta, 0.0, 0.0)};
}

Pose2 planar(const Pose3& pose) {
  const Eigen::Vector3d forward = pose.rotation * Eigen::Vector3d::UnitX();
  return {pose.position.x(), pose.position.y(),
          normalized_angle(std::atan2(forward.y(), forward.x()))};
}

Eigen::Quaterniond rotation_of(double yaw, double pitch, double roll) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

double distance(const Pose3& a, const Pose3& b) {
  return (a.position - b.position).norm();
}

double angle_between(const Pose3& a, const Pose3& b) {
  return a.rotation.angularDistance(b.rotation);
}

bool is_finite(const Pose3& pose) {
  return pose.position.allFinite() && pose.rotation.coeffs().allFinite();
}

}  // namespace mapbed
