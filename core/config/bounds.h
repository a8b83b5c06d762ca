#pragma once

#include <limits>

namespace mapbed {

// The values that make sense, in SI: of a number, or of every element of a list.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_itself = true;  // may the value be `low`?
};

inline constexpr Bounds kAnyValue;
inline constexpr Bounds kPositive{.low = 0.0, .low_itself = false};
inline constexpr Bounds kNotNegative{.low = 0.0};
inline constexpr Bounds kFraction{.low = 0.0, .high = 1.0};  // probabilities and the like
constexpr Bounds at_least(double low) {
  return {.low = low};
}
constexpr Bounds between(double low, double high) {  // both included
  return {.low = low, .high = high};
}

}  // namespace mapbed
