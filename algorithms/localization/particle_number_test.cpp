#include "algorithms/localization/particle_number.h"

#include <gtest/gtest.h>

#include "core/statistics/distributions.h"

namespace mapbed {
namespace {

// Fox (2003), (7): n = chi-square quantile of k - 1 freedoms, over 2 epsilon; Wilson and Hilferty's
// approximation is right to a per cent.
TEST(ParticleNumber, IsTheQuantileOfChiSquareOverTwiceTheError) {
  const ParticleNumberOptions options{.least = 1, .most = 1'000'000};
  for (const int bins : {10, 50, 500}) {
    const double expected = chi_square_quantile(0.99, bins - 1) / (2.0 * 0.05);
    EXPECT_NEAR(static_cast<double>(particle_number(static_cast<std::size_t>(bins), options)),
                expected, 0.01 * expected);
  }
}

TEST(ParticleNumber, StaysBetweenTheLeastAndTheMost) {
  const ParticleNumberOptions options{.least = 100, .most = 2000};
  EXPECT_EQ(particle_number(1, options), 100u);
  EXPECT_EQ(particle_number(2, options), 100u);
  EXPECT_EQ(particle_number(100'000, options), 2000u);
}

}  // namespace
}  // namespace mapbed
