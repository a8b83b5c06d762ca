#pragma once

#include <Eigen/Core>

namespace mapbed {

// A rigid motion in the plane. Named target_from_source: it takes points of the source frame to the
// target frame, so that neighbouring frames cancel in a product.
struct Pose2 {
  double x = 0.0;      // [m]
  double y = 0.0;      // [m]
  double theta = 0.0;  // [rad] in (-pi, pi]

  Eigen::Vector2d position() const { return {x, y}; }
  friend bool operator==(const Pose2&, const Pose2&) = default;
};

Pose2 operator*(const Pose2& a_from_b, const Pose2& b_from_c);
Eigen::Vector2d operator*(const Pose2& a_from_b, const Eigen::Vector2d& point_in_b);
Pose2 inverse(const Pose2& a_from_b);

// The motion from one pose to another, both in the same frame: inverse(from) * to.
Pose2 motion_between(const Pose2& world_from_a, const Pose2& world_from_b);

// On the way from a (at fraction 0) to b (at fraction 1): position and heading in a's frame grow
// linearly. Extrapolates outside [0, 1].
Pose2 interpolate(const Pose2& a, const Pose2& b, double fraction);

double distance(const Pose2& a, const Pose2& b);  // [m] between the positions
bool is_finite(const Pose2& pose);

}  // namespace mapbed
