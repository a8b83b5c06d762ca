#include "core/geometry/pose2.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {

Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c) {
  const Eigen::Vector2d position = a_from_b * b_from_c.position();
  return {position.x(), position.y(), normalized_angle(a_from_b.theta + b_from_c.theta)};
}

Eigen::Vector2d operator*(const Pose2& a_from_b, const Eigen::Vector2d& point_in_b) {
  const double c = std::cos(a_from_b.theta);
  const double s = std::sin(a_from_b.theta);
  return {a_from_b.x + c * point_in_b.x() - s * point_in_b.y(),
          a_from_b.y + s * point_in_b.x() + c * point_in_b.y()};
}

Pose2 inverse(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.theta);
  const double s = std::sin(a_from_b.theta);
  return {-c * a_from_b.x - s * a_from_b.y, s * a_from_b.x - c * a_from_b.y,
          normalized_angle(-a_from_b.theta)};
}

Pose2 motion_between(const Pose2& world_from_a, const Pose2& world_from_b) {
  return inverse(world_from_a) * world_from_b;
}

Pose2 interpolate(const Pose2& a, const Pose2& b, double fraction) {
  const Pose2 step = motion_between(a, b);
  return a * Pose2{fraction * step.x, fraction * step.y, normalized_angle(fraction * step.theta)};
}

double distance(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}

}  // namespace mapbed
