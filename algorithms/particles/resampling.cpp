#include "algorithms/particles/resampling.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace mapbed {

std::vector<double> normalized(const std::vector<double>& log_weights) {
  CHECK(!log_weights.empty());
  const double largest = *std::max_element(log_weights.begin(), log_weights.end());
  if (!std::isfinite(largest)) {
    return std::vector<double>(log_weights.size(), 1.0 / static_cast<double>(log_weights.size()));
  }
  std::vector<double> weights;
  weights.reserve(log_weights.size());
  double sum = 0.0;
  for (const double log_weight : log_weights) {
    weights.push_back(std::exp(log_weight - largest));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

double effective_number(const std::vector<double>& weights) {
  double squares = 0.0;
  for (const double weight : weights) squares += weight * weight;
  return 1.0 / squares;
}

std::vector<std::size_t> resampled(const std::vector<double>& weights, Rng& rng) {
  return resampled(weights, weights.size(), rng);
}

std::vector<std::size_t> resampled(const std::vector<double>& weights, std::size_t count,
                                   Rng& rng) {
  CHECK(!weights.empty() && count > 0);
  const double step = 1.0 / static_cast<double>(count);
  const double first = step * rng.uniform();
  std::vector<std::size_t> parents;
  parents.reserve(count);
  std::size_t parent = 0;
  double sum = weights[0];
  for (std::size_t i = 0; i < count; ++i) {
    const double at = first + static_cast<double>(i) * step;
    while (at > sum && parent + 1 < weights.size()) sum += weights[++parent];
    parents.push_back(parent);
  }
  return parents;
}

}  // namespace mapbed
