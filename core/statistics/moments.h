#pragma once

#include <span>

namespace mapbed {

// Mean and variance of numbers that come one after the other, without keeping them (Welford 1962).
// Exact to rounding also where the mean is large against the standard deviation.
class Moments {
 public:
  void add(double value) {
    ++count_;
    const double from_old_mean = value - mean_;
    mean_ += from_old_mean / static_cast<double>(count_);
    squares_ += from_old_mean * (value - mean_);
  }

  long count() const { return count_; }
  double mean() const;      // NaN where there are none, as the next ones
  double variance() const;  // of the population
  double sigma() const;     // its root

 private:
  long count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // of the differences from the mean, summed
};

// Of numbers that are at hand, summed in their order; NaN where there are none.
double mean_of(std::span<const double> values);
double sigma_of(std::span<const double> values);  // of the population
double root_mean_square_of(std::span<const double> values);

}  // namespace mapbed
