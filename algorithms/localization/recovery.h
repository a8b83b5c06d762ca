#pragma once

#include "core/config/option.h"

namespace mapbed {

// When particles are drawn anew from what sensors say (augmented Monte Carlo localisation, Thrun et
// al., Probabilistic Robotics, 2005, section 8.3.5): where the likelihood of readings over a short
// time falls below that over a long one. Half of them are drawn about where the robot was believed
// to be, for odometry that jumped or slipped, the others anywhere, for a robot that was carried.
struct RecoveryOptions {
  double slow = 0.02;       // per update: how fast the long mean follows
  double fast = 0.3;        // the short one
  double most = 0.3;        // of the particles, drawn anew in one update
  double sigma = 0.5;       // [m] of those about where the robot was believed to be
  double turn_sigma = 0.3;  // [rad] the same
};

template <class Visitor>
void visit_fields(RecoveryOptions& o, Visitor&& visit) {
  visit("slow", o.slow, between(0.0, 1.0),
        "how fast the long mean of likelihoods follows, an update");
  visit("fast", o.fast, between(0.0, 1.0), "how fast the short mean follows");
  visit("most", o.most, between(0.0, 0.9),
        "fraction of the particles drawn anew at a time; 0: none");
  visit("sigma", o.sigma, Unit::meter, between(1e-3, 100.0),
        "of those drawn about where the robot was believed to be");
  visit("turn_sigma", o.turn_sigma, Unit::radian, between(1e-3, 10.0), "of their headings");
}

class LikelihoodMeans {
 public:
  explicit LikelihoodMeans(const RecoveryOptions& options) : options_(options) {}

  void add(double likelihood);  // of a reading, by all particles
  void restart() { count_ = 0; }
  double fraction_to_draw() const;  // 1 - fast / slow, where that is positive

 private:
  RecoveryOptions options_;
  double slow_ = 0.0, fast_ = 0.0;
  int count_ = 0;
};

// Whether the robot is where it is taken to be at all, and not off the map, carried away or in
// another building: a chain of two states, that of before and the odds of each measurement.
class PlaceBelief {
 public:
  explicit PlaceBelief(double probability) : probability_(probability) {}

  void add(double log_odds);
  void doubt();  // it is taken to be elsewhere now
  double probability() const { return probability_; }

 private:
  // The probabilities that it changes between two updates: it is rarely carried, and soon looked
  // for.
  static constexpr double kLost = 1e-3;
  static constexpr double kFound = 0.05;
  double probability_;
};

}  // namespace mapbed
