#pragma once

#include <cmath>

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace mapbed {

// A motion for many points: the same bytes as Pose2 * point, with its sine and cosine made once.
class PointMotion {
 public:
  PointMotion() = default;
  explicit PointMotion(const Pose2& a_from_b)
      : c_(std::cos(a_from_b.theta)),
        s_(std::sin(a_from_b.theta)),
        x_(a_from_b.x),
        y_(a_from_b.y) {}

  Eigen::Vector2d operator*(const Eigen::Vector2d& point_in_b) const {
    return {x_ + c_ * point_in_b.x() - s_ * point_in_b.y(),
            y_ + s_ * point_in_b.x() + c_ * point_in_b.y()};
  }

 private:
  double c_ = 1.0, s_ = 0.0;
  double x_ = 0.0, y_ = 0.0;  // [m]
};

}  // namespace mapbed
