#include "algorithms/localization/recovery.h"

#include <algorithm>
#include <cmath>

namespace mapbed {

void LikelihoodMeans::add(double likelihood) {
  ++count_;
  // The first ones are plain means, so that both begin alike.
  const double first = 1.0 / count_;
  slow_ += std::max(first, options_.slow) * (likelihood - slow_);
  fast_ += std::max(first, options_.fast) * (likelihood - fast_);
}

double LikelihoodMeans::fraction_to_draw() const {
  return slow_ > 0.0 ? std::clamp(1.0 - fast_ / slow_, 0.0, options_.most) : 0.0;
}

void PlaceBelief::add(double log_odds) {
  const double before = probability_ * (1.0 - kLost) + (1.0 - probability_) * kFound;
  const double odds = before / (1.0 - before) * std::exp(std::clamp(log_odds, -50.0, 50.0));
  probability_ = odds / (1.0 + odds);
}

void PlaceBelief::doubt() {
  probability_ = std::min(probability_, 0.5);
}

}  // namespace mapbed
