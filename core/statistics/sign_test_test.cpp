#include "core/statistics/sign_test.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(SignTest, HasTheProbabilitiesOfFairCoins) {
  EXPECT_NEAR(sign_test_probability(5, 0), 1.0 / 32.0, 1e-12);
  EXPECT_NEAR(sign_test_probability(4, 1), 6.0 / 32.0, 1e-12);
  EXPECT_NEAR(sign_test_probability(0, 5), 1.0, 1e-12);
  EXPECT_EQ(sign_test_probability(0, 0), 1.0);  // no pairs say nothing
}

}  // namespace
}  // namespace mapbed
