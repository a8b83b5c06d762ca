#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "core/check.h"

namespace mapbed {

// The value with the given fraction of the others below it: number floor(fraction * n) of the n
// sorted ones, from 0; the largest for a fraction of 1. The values must not be empty or NaN.
template <class Number>
Number quantile_of(std::vector<Number> values, double fraction) {
  CHECK(!values.empty() && fraction >= 0.0 && fraction <= 1.0);
  // 0.9 * 70 may be 62.999…
  const double rank = std::floor(fraction * static_cast<double>(values.size()) + 1e-9);
  const std::size_t index = std::min(values.size() - 1, static_cast<std::size_t>(rank));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(index);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The middle value, or the mean of the two in the middle; NaN where there are none.
double median_of(std::vector<double> values);

}  // namespace mapbed
