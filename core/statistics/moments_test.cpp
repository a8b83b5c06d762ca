#include "core/statistics/moments.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

const std::vector<double> kValues{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};  // mean 5, sigma 2

TEST(Moments, AreThoseOfTheNumbersSoFar) {
  Moments moments;
  for (const double value : kValues) moments.add(value);
  EXPECT_EQ(moments.count(), 8);
  EXPECT_DOUBLE_EQ(moments.mean(), 5.0);
  EXPECT_DOUBLE_EQ(moments.variance(), 4.0);
  EXPECT_DOUBLE_EQ(moments.sigma(), 2.0);
}

TEST(Moments, KeepASmallSigmaAboutALargeMean) {
  Moments moments;
  for (const double value : kValues) moments.add(1e9 + value);
  EXPECT_NEAR(moments.variance(), 4.0, 1e-6);  // the sum of squares would be off by hundreds
}

TEST(Moments, OfNumbersAtHandAreTheSame) {
  EXPECT_DOUBLE_EQ(mean_of(kValues), 5.0);
  EXPECT_DOUBLE_EQ(sigma_of(kValues), 2.0);
  EXPECT_DOUBLE_EQ(root_mean_square_of(kValues), std::sqrt(29.0));
}

TEST(Moments, OfNothingAreNotANumber) {
  EXPECT_TRUE(std::isnan(Moments().mean()));
  EXPECT_TRUE(std::isnan(Moments().sigma()));
  EXPECT_TRUE(std::isnan(mean_of({})));
  EXPECT_TRUE(std::isnan(sigma_of({})));
  EXPECT_TRUE(std::isnan(root_mean_square_of({})));
}

}  // namespace
}  // namespace mapbed
