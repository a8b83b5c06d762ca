#include "core/statistics/distributions.h"

#include <cmath>
#include <limits>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// Regularised incomplete gamma function P(a, x) = integral of t^(a-1) e^-t from 0 to x / Gamma(a):
// by its series below a + 1, by the continued fraction of 1 - P above (Abramowitz and Stegun 1964,
// 6.5.29 and 6.5.31; the fraction by Lentz's method).
double gamma_below(double a, double x) {
  if (x <= 0.0) return 0.0;
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1.0) {
    double term = 1.0 / a;
    double sum = term;
    for (double n = a + 1.0; term > kEpsilon * sum; n += 1.0) {
      term *= x / n;
      sum += term;
    }
    return front * sum;
  }
  double b = x + 1.0 - a;
  double c = std::numeric_limits<double>::max();
  double d = 1.0 / b;
  double fraction = d;
  for (double n = 1.0, change = 0.0; std::abs(change - 1.0) > kEpsilon; n += 1.0) {
    const double numerator = -n * (n - a);
    b += 2.0;
    d = 1.0 / (numerator * d + b);
    c = b + numerator / c;
    change = c * d;
    fraction *= change;
  }
  return 1.0 - front * fraction;
}

// Where an increasing function takes a value, by halving to the last bits.
template <class Function>
double solution(Function function, double value, double low, double high) {
  for (;;) {
    const double middle = low + 0.5 * (high - low);
    if (high - low <= kEpsilon * std::abs(middle) || middle == low || middle == high) return middle;
    (function(middle) < value ? low : high) = middle;
  }
}

}  // namespace

double normal_below(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

double normal_quantile(double fraction) {
  CHECK(fraction > 0.0 && fraction < 1.0);
  if (fraction == 0.5) return 0.0;
  if (fraction > 0.5) return -normal_quantile(1.0 - fraction);
  return solution(normal_below, fraction, -40.0, 0.0);
}

double chi_square_below(double x, int freedoms) {
  CHECK(freedoms > 0);
  return gamma_below(0.5 * freedoms, 0.5 * x);
}

double chi_square_quantile(double fraction, int freedoms) {
  CHECK(fraction > 0.0 && fraction < 1.0);
  const auto below = [freedoms](double x) { return chi_square_below(x, freedoms); };
  double high = freedoms;
  while (below(high) < fraction) high *= 2.0;
  return solution(below, fraction, 0.0, high);
}

}  // namespace mapbed
