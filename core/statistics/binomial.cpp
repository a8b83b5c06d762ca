#include "core/statistics/binomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics/distributions.h"

namespace mapbed {

Interval binomial_interval(double fraction, int trials) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (trials <= 0) return {kNone, kNone};
  const double n = trials;
  const double z = normal_quantile(0.975);
  const double middle = (fraction + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half =
      z / (1.0 + z * z / n) * std::sqrt(fraction * (1.0 - fraction) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace mapbed
