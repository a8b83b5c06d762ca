#pragma once

#include <span>

namespace mapbed {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// 95 % percentile bootstrap interval of the mean (Efron 1979), from 2000 resamples that are drawn
// from one fixed stream: the same values give the same interval. NaN for fewer than two values.
Interval bootstrap_interval(std::span<const double> values);

}  // namespace mapbed
