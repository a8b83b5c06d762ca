#include "algorithms/pose_graph/constraint_error.h"

#include <cmath>

#include <Eigen/Geometry>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Matrix2d rotation_matrix(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return (Matrix2d() << c, -s, s, c).finished();
}

// cross_matrix(a) * b is a x b.
Matrix3d cross_matrix(const Vector3d& v) {
  return (Matrix3d() << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0).finished();
}

Eigen::Quaterniond with_positive_w(const Eigen::Quaterniond& q) {
  return q.w() < 0.0 ? Eigen::Quaterniond(-q.coeffs()) : q;
}

Eigen::Quaterniond rotation_by(const Vector3d& turn) {
  const double angle = turn.norm();
  // sin(angle / 2) / angle, by its series where it is 0/0
  const double scale = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = scale * turn;
  return q;
}

}  // namespace

Pose2 moved(const Pose2& pose, const PoseTangent<Pose2>& step) {
  return {pose.x + step.x(), pose.y + step.y(), normalized_angle(pose.theta + step.z())};
}

Pose3 moved(const Pose3& pose, const PoseTangent<Pose3>& step) {
  return {pose.position + step.head<3>(),
          (pose.rotation * rotation_by(step.tail<3>())).normalized()};
}

PoseTangent<Pose2> constraint_error(const Pose2& from_from_to, const Pose2& map_from_from,
                                    const Pose2& map_from_to) {
  const Vector2d way = map_from_to.position() - map_from_from.position();
  const Vector2d off = rotation_matrix(-map_from_from.theta) * way - from_from_to.position();
  PoseTangent<Pose2> error;
  error.head<2>() = rotation_matrix(-from_from_to.theta) * off;
  error.z() = normalized_angle(map_from_to.theta - map_from_from.theta - from_from_to.theta);
  return error;
}

PoseTangent<Pose3> constraint_error(const Pose3& from_from_to, const Pose3& map_from_from,
                                    const Pose3& map_from_to) {
  const Vector3d way = map_from_to.position - map_from_from.position;
  const Vector3d off = map_from_from.rotation.conjugate() * way - from_from_to.position;
  PoseTangent<Pose3> error;
  error.head<3>() = from_from_to.rotation.conjugate() * off;
  error.tail<3>() = with_positive_w(from_from_to.rotation.conjugate() *
                                    (map_from_from.rotation.conjugate() * map_from_to.rotation))
                        .vec();
  return error;
}

LinearError<Pose2> linear_error(const Pose2& from_from_to, const Pose2& map_from_from,
                                const Pose2& map_from_to) {
  const Vector2d way = map_from_to.position() - map_from_from.position();
  const Matrix2d from_from_map = rotation_matrix(-map_from_from.theta);
  const Matrix2d to_from_from = rotation_matrix(-from_from_to.theta);
  const Matrix2d turned = to_from_from * from_from_map;
  const Vector2d seen = from_from_map * way;

  LinearError<Pose2> linear;
  linear.error.head<2>() = to_from_from * (seen - from_from_to.position());
  linear.error.z() = normalized_angle(map_from_to.theta - map_from_from.theta - from_from_to.theta);
  linear.by_from.setZero();
  linear.by_from.topLeftCorner<2, 2>() = -turned;
  linear.by_from.topRightCorner<2, 1>() = to_from_from * Vector2d(seen.y(), -seen.x());
  linear.by_from(2, 2) = -1.0;
  linear.by_to.setZero();
  linear.by_to.topLeftCorner<2, 2>() = turned;
  linear.by_to(2, 2) = 1.0;
  return linear;
}

LinearError<Pose3> linear_error(const Pose3& from_from_to, const Pose3& map_from_from,
                                const Pose3& map_from_to) {
  const Vector3d way = map_from_to.position - map_from_from.position;
  const Matrix3d from_from_map = map_from_from.rotation.conjugate().toRotationMatrix();
  const Matrix3d to_from_from = from_from_to.rotation.conjugate().toRotationMatrix();
  const Matrix3d turned = to_from_from * from_from_map;
  const Vector3d seen = from_from_map * way;
  const Eigen::Quaterniond rest =
      with_positive_w(from_from_to.rotation.conjugate() *
                      (map_from_from.rotation.conjugate() * map_from_to.rotation));
  const Matrix3d along = rest.w() * Matrix3d::Identity();
  const Matrix3d across = cross_matrix(rest.vec());

  LinearError<Pose3> linear;
  linear.error.head<3>() = to_from_from * (seen - from_from_to.position);
  linear.error.tail<3>() = rest.vec();
  linear.by_from.setZero();
  linear.by_from.topLeftCorner<3, 3>() = -turned;
  linear.by_from.topRightCorner<3, 3>() = to_from_from * cross_matrix(seen);
  // The vector part of (1, -t/2) rest and of rest (1, t/2) for small turns t.
  linear.by_from.bottomRightCorner<3, 3>() = -0.5 * (along - across) * to_from_from;
  linear.by_to.setZero();
  linear.by_to.topLeftCorner<3, 3>() = turned;
  linear.by_to.bottomRightCorner<3, 3>() = 0.5 * (along + across);
  return linear;
}

}  // namespace mapbed
