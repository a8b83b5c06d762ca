#pragma once

namespace mapbed {

// The normal distribution with mean 0 and standard deviation 1. Both are exact to a few units in
// the last place of 15 digits, in the lower tail too.
double normal_below(double x);            // probability of a value below x
double normal_quantile(double fraction);  // the x with this probability below it; 0 < fraction < 1

// The chi-square distribution: of the sum of k squares of such numbers.
double chi_square_below(double x, int freedoms);
double chi_square_quantile(double fraction, int freedoms);  // 0 < fraction < 1

}  // namespace mapbed
