#pragma once

#include <span>

namespace mapbed {

// How well counts fit what was expected of them.
struct ChiSquare {
  double value = 0.0;     // sum of (observed - expected)^2 / expected
  int classes = 0;        // that were compared; values and freedoms are 0 for less than two
  int freedoms = 0;       // classes - 1
  double score = 0.0;     // see chi_square_score()
  double expected = 0.0;  // all counts
  double observed = 0.0;  // the same
};

// Of a chi-square value with k freedoms, a number that is standard normal where the expectation is
// right, by the cube root of Wilson and Hilferty (1931):
// ((value / k)^(1/3) - (1 - 2 / (9 k))) / sqrt(2 / (9 k)). From k = 3 on its upper tail is that of
// the normal distribution within a few per cent.
double chi_square_score(double value, int freedoms);

// Pearson's test of counts of independent draws. Neighbouring classes are put together until at
// least `least` draws are expected in each.
ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected,
                     double least = 5.0);

}  // namespace mapbed
