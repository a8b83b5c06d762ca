#include "core/statistics/binomial.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// The bounds p solve |fraction - p| = z sqrt(p (1 - p) / n).
TEST(BinomialInterval, EndsWhereTheFractionIsTwoSigmasOff) {
  const double z = 1.959963984540054;
  const Interval interval = binomial_interval(0.3, 50);
  for (const double p : {interval.low, interval.high}) {
    EXPECT_NEAR(std::abs(0.3 - p), z * std::sqrt(p * (1.0 - p) / 50.0), 1e-9);
  }
  EXPECT_LT(interval.low, 0.3);
  EXPECT_GT(interval.high, 0.3);
}

// Of none of n: p = z^2 / (n + z^2).
TEST(BinomialInterval, OfNoneIsNotEmpty) {
  EXPECT_EQ(binomial_interval(0.0, 50).low, 0.0);
  EXPECT_NEAR(binomial_interval(0.0, 50).high, 3.841458820694124 / 53.841458820694124, 1e-9);
  EXPECT_EQ(binomial_interval(1.0, 50).high, 1.0);
  EXPECT_TRUE(std::isnan(binomial_interval(0.0, 0).low));
}

}  // namespace
}  // namespace mapbed
