#include "sim/actors/gait.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kSettling = 0.3;  // [s] a change of step length takes about this long

// Of a foot from the hip, in steps, over its cycle: stands for the first half, swings in the
// second.
double foot_offset(double phase) {
  if (phase < 0.5) return 0.5 - 2.0 * phase;
  return -0.5 * std::cos(2.0 * kPi * (phase - 0.5));
}

}  // namespace

void Gait::advance(double speed, double dt) {
  const double forward = std::abs(speed);
  const double wanted = options_.step_length * std::min(1.0, forward / options_.full_speed);
  stride_ += (wanted - stride_) * std::min(1.0, dt / kSettling);
  // The standing foot stays where it is: half a cycle for a way of one step.
  const double cycles = speed * dt / (2.0 * std::max(stride_, 0.15));
  phase_ += cycles - std::floor(phase_ + cycles);
}

std::array<Eigen::Vector2d, 2> Gait::legs() const {
  const double lever = 1.0 - options_.knee_height / options_.hip_height;
  const double other = phase_ < 0.5 ? phase_ + 0.5 : phase_ - 0.5;
  const double swing = lever * stride_;
  return {Eigen::Vector2d(swing * foot_offset(phase_), options_.hip_width / 2.0),
          Eigen::Vector2d(swing * foot_offset(other), -options_.hip_width / 2.0)};
}

}  // namespace mapbed
