#pragma once

#include <array>

#include <Eigen/Core>

namespace mapbed {

// Two legs as a laser at knee height sees them. Each foot stands still on the floor for one step
// while the body passes over it, then swings forward; the leg at height h is between hip and foot,
// so its swing is 1 - h / hip height of the foot's.
struct GaitOptions {
  double step_length = 0.7;   // [m] at walking speed: one foot's place to the other's
  double full_speed = 0.7;    // [m/s] slower walkers take shorter steps
  double hip_width = 0.20;    // [m] between the legs' axes
  double hip_height = 0.90;   // [m]
  double knee_height = 0.40;  // [m] where the legs are right
};

class Gait {
 public:
  Gait(const GaitOptions& options, double phase) : options_(options), phase_(phase) {}

  void advance(double speed, double dt);  // [m/s] forward

  // Axes of the left and right leg in the body frame, x forward. [m]
  std::array<Eigen::Vector2d, 2> legs() const;

 private:
  GaitOptions options_;
  double phase_;         // in [0, 1): one full cycle is two steps
  double stride_ = 0.0;  // [m] present step length
};

}  // namespace mapbed
