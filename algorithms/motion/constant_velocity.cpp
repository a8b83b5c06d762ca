#include "algorithms/motion/constant_velocity.h"

#include <cmath>

#include <Eigen/Dense>

namespace mapbed {

ConstantVelocity ConstantVelocity::at(const Eigen::Vector2d& position, double position_sigma,
                                      double speed_sigma) {
  ConstantVelocity result;
  result.mean.head<2>() = position;
  result.covariance.topLeftCorner<2, 2>() *= position_sigma * position_sigma;
  result.covariance.bottomRightCorner<2, 2>() *= speed_sigma * speed_sigma;
  return result;
}

void ConstantVelocity::predict(double seconds, double acceleration) {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topRightCorner<2, 2>() = seconds * Eigen::Matrix2d::Identity();
  // White noise of the acceleration, integrated.
  const double q = acceleration * acceleration;
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  noise.topLeftCorner<2, 2>() = q * seconds * seconds * seconds / 3.0 * one;
  noise.topRightCorner<2, 2>() = q * seconds * seconds / 2.0 * one;
  noise.bottomLeftCorner<2, 2>() = noise.topRightCorner<2, 2>();
  noise.bottomRightCorner<2, 2>() = q * seconds * one;
  mean = motion * mean;
  covariance = motion * covariance * motion.transpose() + noise;
}

void ConstantVelocity::correct(const Eigen::Vector2d& position, double sigma) {
  const Eigen::Matrix2d innovation =
      covariance.topLeftCorner<2, 2>() + sigma * sigma * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 4, 2> gain = covariance.leftCols<2>() * innovation.inverse();
  mean += gain * (position - mean.head<2>());
  covariance -= gain * innovation * gain.transpose();
}

double ConstantVelocity::longest_sigma() const {
  const double half = (covariance(0, 0) + covariance(1, 1)) / 2.0;
  const double difference = (covariance(0, 0) - covariance(1, 1)) / 2.0;
  return std::sqrt(half + std::hypot(difference, covariance(0, 1)));
}

}  // namespace mapbed
