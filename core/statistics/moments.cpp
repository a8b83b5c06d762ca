#include "core/statistics/moments.h"

#include <cmath>
#include <limits>

namespace mapbed {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double Moments::mean() const {
  return count_ > 0 ? mean_ : kNone;
}

double Moments::variance() const {
  return count_ > 0 ? squares_ / static_cast<double>(count_) : kNone;
}

double Moments::sigma() const {
  return std::sqrt(variance());
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? kNone : sum / static_cast<double>(values.size());
}

double sigma_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return values.empty() ? kNone : std::sqrt(squares / static_cast<double>(values.size()));
}

double root_mean_square_of(std::span<const double> values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return values.empty() ? kNone : std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace mapbed
