#pragma once

#include <Eigen/Core>

namespace mapbed {

// A Kalman filter's belief of something that goes on as it went: x, y [m]; vx, vy [m/s].
struct ConstantVelocity {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();

  // At rest or not: sigmas of the position [m] and, along each axis, of the velocity [m/s].
  static ConstantVelocity at(const Eigen::Vector2d& position, double position_sigma,
                             double speed_sigma);

  // `acceleration`: sigma of the change of velocity [m/s] after 1 s, which grows with the root.
  void predict(double seconds, double acceleration);
  void correct(const Eigen::Vector2d& position, double sigma);

  double longest_sigma() const;  // [m] of the position
};

}  // namespace mapbed
