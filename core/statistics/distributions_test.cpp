#include "core/statistics/distributions.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(NormalDistribution, HasTheProbabilitiesOfTables) {
  EXPECT_EQ(normal_below(0.0), 0.5);
  EXPECT_NEAR(normal_below(1.0) - normal_below(-1.0), std::erf(1.0 / std::sqrt(2.0)), 1e-15);
  EXPECT_NEAR(normal_below(1.959963984540054), 0.975, 1e-15);
  EXPECT_NEAR(normal_below(-6.0) / 9.865876450376981e-10, 1.0, 1e-13);
}

TEST(NormalDistribution, TheQuantileIsTheInverse) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.01), -2.326347874040841, 1e-14);
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  for (const double p : {1e-300, 1e-12, 0.3, 0.499999})
    EXPECT_NEAR(normal_below(normal_quantile(p)) / p, 1.0, 1e-12) << p;
}

TEST(ChiSquareDistribution, HasTheProbabilitiesOfClosedForms) {
  for (const double x : {1e-8, 0.1, 1.0, 3.0, 3.9, 4.1, 10.0, 60.0}) {
    const double root = std::sqrt(x);
    const double one = std::erf(root / std::sqrt(2.0));
    EXPECT_NEAR(chi_square_below(x, 1), one, 1e-14) << x;
    EXPECT_NEAR(chi_square_below(x, 2), -std::expm1(-x / 2.0), 1e-14) << x;
    const double density = std::sqrt(2.0 / M_PI) * root * std::exp(-x / 2.0);
    EXPECT_NEAR(chi_square_below(x, 3), one - density, 1e-14) << x;
    EXPECT_NEAR(chi_square_below(x, 4), 1.0 - (1.0 + x / 2.0) * std::exp(-x / 2.0), 1e-14) << x;
  }
  EXPECT_EQ(chi_square_below(0.0, 5), 0.0);
  EXPECT_EQ(chi_square_below(-1.0, 5), 0.0);
}

TEST(ChiSquareDistribution, HasTheQuantilesOfTables) {
  EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841458820694124, 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.95, 2), -2.0 * std::log(0.05), 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.95, 3), 7.814727903251179, 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.99, 30), 50.89218131, 1e-7);
  EXPECT_NEAR(chi_square_quantile(0.05, 1000), 927.594363, 1e-5);
  EXPECT_NEAR(chi_square_below(chi_square_quantile(1e-9, 3), 3) / 1e-9, 1.0, 1e-9);
}

}  // namespace
}  // namespace mapbed
