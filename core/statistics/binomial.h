#pragma once

#include "core/statistics/bootstrap.h"

namespace mapbed {

// 95 % interval of a probability, by the fraction of so many trials in which something came (Wilson
// 1927): it is never empty, also where it came in none of them or in all. NaN without trials.
Interval binomial_interval(double fraction, int trials);

}  // namespace mapbed
