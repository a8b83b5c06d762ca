#include "core/statistics/bootstrap.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

TEST(Bootstrap, CoversTheTrueMeanNineteenTimesInTwenty) {
  constexpr int kTrials = 400;
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Rng rng = Rng(5).stream("trial", static_cast<std::uint64_t>(trial));
    std::vector<double> values(30);
    for (double& value : values) value = rng.normal(2.0, 1.0);
    const Interval interval = bootstrap_interval(values);
    covered += interval.low <= 2.0 && 2.0 <= interval.high ? 1 : 0;
  }
  // Percentile intervals of 30 values cover a little less than 95 %; four standard errors.
  EXPECT_NEAR(covered / static_cast<double>(kTrials), 0.94, 4 * std::sqrt(0.94 * 0.06 / kTrials));
}

// Four equally likely resamples: the first twice, both, both, the last twice.
TEST(Bootstrap, DrawsTheFirstAndTheLastValueToo) {
  const Interval interval = bootstrap_interval(std::vector<double>{3.0, 5.0});
  EXPECT_EQ(interval.low, 3.0);
  EXPECT_EQ(interval.high, 5.0);
}

// Means of 200 evenly spread values are normal, with the sigma of a uniform distribution over 200
// steps, by sqrt(200). Each end is a quantile of 2000 of them: a standard error of
// sqrt(0.025 * 0.975 / 2000) / (density at 1.96) = 0.060 sigma, half the width one of 0.042 sigma.
TEST(Bootstrap, ReachesNinetyFivePercentOfTheMeans) {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(i);
  const double sigma = std::sqrt((200.0 * 200.0 - 1.0) / 12.0 / 200.0);
  const Interval interval = bootstrap_interval(values);
  EXPECT_NEAR(interval.low, 99.5 - 1.960 * sigma, 4 * 0.060 * sigma);
  EXPECT_NEAR(interval.high, 99.5 + 1.960 * sigma, 4 * 0.060 * sigma);
  EXPECT_NEAR((interval.high - interval.low) / 2.0, 1.960 * sigma, 4 * 0.042 * sigma);
}

TEST(Bootstrap, TheSameValuesGiveTheSameInterval) {
  const std::vector<double> values{1.0, 2.0, 4.0, 8.0};
  EXPECT_EQ(bootstrap_interval(values).low, bootstrap_interval(values).low);
  EXPECT_GE(bootstrap_interval(values).low, 1.0);
  EXPECT_LE(bootstrap_interval(values).high, 8.0);
  EXPECT_TRUE(std::isnan(bootstrap_interval(std::vector<double>{1.0}).low));
}

}  // namespace
}  // namespace mapbed
