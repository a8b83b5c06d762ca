#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "algorithms/pose_graph/normal_equations.h"

// How long steps are: three ways from the same equations, which stand at the last pose that was
// taken. A step that does not lower the cost is answered by a shorter one. All of it for the sum of
// squares F(step) = F + 2 gradient' step + step' H step.

namespace mapbed {

struct Step {
  Eigen::VectorXd step;
  double predicted = 0.0;  // by how much the cost falls, by the equations
};

// (H + damping diag(H)) step = -gradient; the damping follows how well decreases were predicted, by
// Nielsen (1999).
template <class Pose>
class LevenbergMarquardt {
 public:
  // Nothing where no damping makes H positive definite.
  std::optional<Step> propose(NormalEquations<Pose>& equations) {
    while (!equations.factorize(damping_)) {
      if (damping_ > kMostDamping) return {};
      rejected();
    }
    Step result;
    result.step = equations.solve(-equations.gradient());
    result.predicted = -equations.gradient().dot(result.step) +
                       damping_ * result.step.dot(equations.diagonal().cwiseProduct(result.step));
    return result;
  }

  void accepted(double gain) {
    damping_ *= std::max(kLeastFactor, 1.0 - std::pow(2.0 * gain - 1.0, 3));
    damping_ = std::max(damping_, kLeastDamping);
    growth_ = 2.0;
  }
  // False where it makes no sense to go on.
  bool rejected() {
    damping_ *= growth_;
    growth_ *= 2.0;
    return damping_ < kMostDamping;
  }
  bool is_free() const { return damping_ < 1e-2; }  // the step is nearly that of Gauss-Newton

 private:
  static constexpr double kLeastFactor = 0.1;
  static constexpr double kLeastDamping = 1e-12;
  static constexpr double kMostDamping = 1e12;

  double damping_ = 1e-5;
  double growth_ = 2.0;
};

// Powell's: from the lowest point along the gradient towards the step of Gauss-Newton, as far as
// is trusted, in units of the diagonal of H.
template <class Pose>
class Dogleg {
 public:
  std::optional<Step> propose(NormalEquations<Pose>& equations) {
    if (is_new_) {
      if (!look(equations)) return {};
      is_new_ = false;
    }
    Step result;
    const double newton_length = scaled_norm(newton_);
    is_free_ = radius_ <= 0.0 || newton_length <= radius_;
    if (is_free_) {
      if (radius_ <= 0.0) radius_ = newton_length;
      result.step = newton_;
    } else if (const double length = scaled_norm(cauchy_); length >= radius_) {
      result.step = cauchy_ * (radius_ / length);
    } else {
      const Eigen::VectorXd rest = newton_ - cauchy_;
      const double a = scaled_dot(rest, rest);
      const double b = scaled_dot(cauchy_, rest);
      const double c = length * length - radius_ * radius_;
      result.step = cauchy_ + rest * ((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a);
    }
    result.predicted = -2.0 * equations.gradient().dot(result.step) -
                       result.step.dot(equations.times(result.step));
    return result;
  }

  void accepted(double gain) {
    is_new_ = true;
    if (gain > 0.75) radius_ *= 3.0;
    if (gain < 0.25) radius_ *= 0.5;
  }
  bool rejected() {
    radius_ *= 0.25;
    return radius_ > 1e-12;
  }
  bool is_free() const { return is_free_; }

 private:
  bool look(NormalEquations<Pose>& equations) {
    scale_ = equations.diagonal().cwiseMax(1e-6);
    double damping = 0.0;
    while (!equations.factorize(damping)) {
      damping = damping == 0.0 ? 1e-9 : 10.0 * damping;
      if (damping > 1e6) return false;
    }
    newton_ = equations.solve(-equations.gradient());
    const Eigen::VectorXd downhill = -equations.gradient().cwiseQuotient(scale_);
    const double curvature = downhill.dot(equations.times(downhill));
    cauchy_ = downhill;
    if (curvature > 0.0) cauchy_ *= -equations.gradient().dot(downhill) / curvature;
    return true;
  }

  double scaled_dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return a.dot(scale_.cwiseProduct(b));
  }
  double scaled_norm(const Eigen::VectorXd& a) const { return std::sqrt(scaled_dot(a, a)); }

  Eigen::VectorXd scale_, newton_, cauchy_;
  double radius_ = 0.0;  // not known before the first step
  bool is_new_ = true;
  bool is_free_ = true;
};

// The bare step, whether or not it lowers the cost.
template <class Pose>
class GaussNewton {
 public:
  std::optional<Step> propose(NormalEquations<Pose>& equations) {
    if (!equations.factorize(0.0)) return {};
    Step result;
    result.step = equations.solve(-equations.gradient());
    result.predicted = -equations.gradient().dot(result.step);
    return result;
  }
  void accepted(double) {}
  bool rejected() { return false; }
  bool is_free() const { return true; }
};

}  // namespace mapbed
