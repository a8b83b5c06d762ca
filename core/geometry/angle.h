#pragma once

#include <cmath>
#include <numbers>

namespace mapbed {

inline constexpr double kPi = std::numbers::pi;

constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / kPi);
}

// The same angle in (-pi, pi]. NaN stays NaN.
inline double normalized_angle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

// to - from, the short way round, in (-pi, pi].
inline double angle_difference(double from, double to) {
  return normalized_angle(to - from);
}

}  // namespace mapbed
