#include "core/statistics/sign_test.h"

#include <algorithm>
#include <cmath>

namespace mapbed {

double sign_test_probability(int wins, int losses) {
  const int n = wins + losses;
  double probability = 0.0;
  for (int k = wins; k <= n; ++k) {
    probability += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) -
                            n * std::log(2.0));
  }
  return std::min(1.0, probability);
}

}  // namespace mapbed
