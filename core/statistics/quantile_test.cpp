#include "core/statistics/quantile.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(Median, IsTheMiddleOneOrTheMeanOfBoth) {
  EXPECT_EQ(median_of({9.0, 1.0, 4.0}), 4.0);
  EXPECT_EQ(median_of({9.0, 1.0, 4.0, 2.0}), 3.0);
  EXPECT_EQ(median_of({5.0}), 5.0);
  EXPECT_TRUE(std::isnan(median_of({})));
}

TEST(Quantile, HasTheFractionBelowIt) {
  const std::vector<float> values{9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
  EXPECT_EQ(quantile_of(values, 0.0), 0.0F);
  EXPECT_EQ(quantile_of(values, 0.9), 9.0F);
  EXPECT_EQ(quantile_of(values, 0.35), 3.0F);
  EXPECT_EQ(quantile_of(values, 1.0), 9.0F);
}

TEST(Quantile, CountsNineTenthsOfAnyNumberOfValuesExactly) {
  std::vector<double> values;
  for (std::size_t n = 1; n <= 1000; ++n) {
    values.push_back(static_cast<double>(n - 1));
    EXPECT_EQ(quantile_of(values, 0.9), static_cast<double>(n * 9 / 10)) << n;
  }
}

}  // namespace
}  // namespace mapbed
