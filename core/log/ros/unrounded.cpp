#include "core/log/ros/unrounded.h"

#include <cmath>
#include <optional>

#include "core/geometry/angle.h"
#include "core/geometry/pose3.h"

namespace mapbed {
namespace {

constexpr double kPlaces = 1e9;  // that count of a double

double nearest_decimal(double value, double scale) {
  return std::nearbyint(value * scale) / scale;
}

// The first one for which `is_meant`. Halves, thirds, tenths; 1024 steps to the circle, as many
// lasers have them, are 45/128 of a degree.
template <class IsMeant>
std::optional<double> fraction_of_degree(double angle, IsMeant is_meant) {
  for (const double denominator : {720.0, 1000.0, 1024.0}) {
    const double fraction = radians(nearest_decimal(degrees(angle), denominator));
    if (is_meant(fraction)) return fraction;
  }
  return {};
}

}  // namespace

double unrounded(float value) {
  constexpr double kMost = 1e7;  // whole floats from here on
  const auto exact = static_cast<double>(value);
  if (!(std::abs(exact) < kMost)) return exact;
  for (const double scale : {1e3, 1e4, 1e6}) {
    const double decimal = nearest_decimal(exact, scale);
    if (static_cast<float>(decimal) == value) return decimal;
  }
  return exact;
}

double unrounded_bearing(float bearing) {
  const auto exact = static_cast<double>(bearing);
  if (!std::isfinite(exact)) return exact;
  const auto fraction = fraction_of_degree(
      exact, [bearing](double angle) { return static_cast<float>(angle) == bearing; });
  if (fraction) return *fraction;
  const double of_small = nearest_decimal(exact, 1e8);  // a step of six digits
  const bool is_small = std::abs(exact) < 0.1 && static_cast<float>(of_small) == bearing;
  return is_small ? of_small : unrounded(bearing);
}

Pose2 unrounded_plan(const Pose3& pose) {
  constexpr double kLost = 1e-15;  // [rad] some units of the last place of pi
  Pose2 plan = planar(pose);
  const double decimal = nearest_decimal(plan.theta, kPlaces);
  if (std::abs(decimal - plan.theta) < kLost) plan.theta = decimal;
  return plan;
}

double unrounded_mount_angle(double angle) {
  const auto fraction = fraction_of_degree(
      angle, [angle](double other) { return std::abs(other - angle) < 1.0 / kPlaces; });
  return fraction.value_or(nearest_decimal(angle, kPlaces)) + 0.0;  // no -0
}

}  // namespace mapbed
