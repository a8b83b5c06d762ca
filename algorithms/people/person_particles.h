#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/config/option.h"
#include "core/random.h"

namespace mapbed {

struct PersonMotionOptions {
  double speed_sigma = 0.8;   // [m/s]
  double acceleration = 0.7;  // [m/s] after 1 s
  double change_rate = 0.25;  // [1/s]
  double stop_fraction = 0.4;
  double top_speed = 2.5;  // [m/s]
};

template <class Visitor>
void visit_fields(PersonMotionOptions& o, Visitor&& visit) {
  visit("speed_sigma", o.speed_sigma, Unit::meter_per_second, between(0.01, 20.0),
        "of the velocity along each axis, of somebody who sets off");
  visit("acceleration", o.acceleration, Unit::meter_per_second, between(0.01, 50.0),
        "sigma of the change of velocity after 1 s; it grows with the root");
  visit("change_rate", o.change_rate, between(0.0, 100.0),
        "how often in a second somebody stops, or goes on in another direction");
  visit("stop_fraction", o.stop_fraction, kFraction, "of these that stop");
  visit("top_speed", o.top_speed, Unit::meter_per_second, between(0.1, 50.0), "of people");
}

// The belief about one person, p(h^i) of section 3.2.1, as samples of position and velocity in the
// local frame, all of equal weight.
class PersonParticles {
 public:
  // Uniform over the view, after a first feature at `position`: normal about it.
  PersonParticles(std::size_t count, const Eigen::Vector2d& position, double sigma,
                  const PersonMotionOptions& motion, Rng rng);

  // p(h_t | h_{t-1}, dt): people go on as before, and stop and turn at times.
  void predict(double seconds, Rng rng);

  // p(theta | h^n) of a feature for each sample [1/m^2], normal with `sigma` [m] and, beyond that,
  // the distance of neighbouring samples, which does not shrink with their spread.
  std::vector<double> likelihoods(const Eigen::Vector2d& feature, double sigma) const;

  // Draws the samples anew by their weights.
  void resample(const std::vector<double>& weights, Rng rng);

  std::size_t size() const { return states_.size(); }
  Eigen::Vector2d sample(std::size_t n) const { return states_[n].head<2>(); }
  Eigen::Vector2d position() const { return mean_.head<2>(); }
  Eigen::Vector2d velocity() const { return mean_.tail<2>(); }
  const Eigen::Matrix2d& covariance() const { return covariance_; }  // [m^2] of the position
  double spread() const;                                             // [m] sigma of the longer axis

  // The fraction of the samples within `radius` [m] of a point, (3.10): over a footprint, so that
  // it does not shrink with the size of a bin.
  double mass_near(const Eigen::Vector2d& point, double radius) const;

 private:
  void summarize();

  PersonMotionOptions motion_;
  std::vector<Eigen::Vector4d> states_;  // x, y [m]; vx, vy [m/s]
  Eigen::Vector4d mean_ = Eigen::Vector4d::Zero();
  Eigen::Matrix2d covariance_ = Eigen::Matrix2d::Zero();
};

}  // namespace mapbed
