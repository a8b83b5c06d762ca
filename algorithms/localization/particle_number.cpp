#include "algorithms/localization/particle_number.h"

#include <algorithm>
#include <cmath>

#include "core/statistics/distributions.h"

namespace mapbed {

std::size_t particle_number(std::size_t occupied_bins, const ParticleNumberOptions& options) {
  const auto least = static_cast<std::size_t>(options.least);
  const auto most = std::max(least, static_cast<std::size_t>(options.most));
  if (occupied_bins < 2) return least;
  // The quantile of chi-square with k - 1 freedoms by Wilson and Hilferty, over 2 epsilon.
  const double freedoms = static_cast<double>(occupied_bins) - 1.0;
  const double part = 2.0 / (9.0 * freedoms);
  const double root = 1.0 - part + std::sqrt(part) * normal_quantile(options.probability);
  const double number = std::ceil(freedoms / (2.0 * options.error) * root * root * root);
  return std::clamp(static_cast<std::size_t>(std::min(number, 1e9)), least, most);
}

}  // namespace mapbed
