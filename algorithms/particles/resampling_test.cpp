#include "algorithms/particles/resampling.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(Resampling, WeightsAreNormalizedWithoutOverflow) {
  const std::vector<double> weights = normalized({1000.0, 1000.0 + std::log(3.0)});
  EXPECT_NEAR(weights[0], 0.25, 1e-12);
  EXPECT_NEAR(weights[1], 0.75, 1e-12);
}

TEST(Resampling, WhereNoWeightIsFiniteAllCountAlike) {
  const double none = -std::numeric_limits<double>::infinity();
  EXPECT_THAT(normalized({none, none}), ::testing::ElementsAre(0.5, 0.5));
}

TEST(Resampling, TheEffectiveNumberLiesBetweenOneAndAll) {
  EXPECT_DOUBLE_EQ(effective_number({0.25, 0.25, 0.25, 0.25}), 4.0);
  EXPECT_DOUBLE_EQ(effective_number({0.0, 1.0}), 1.0);
}

TEST(Resampling, AParticleAppearsAsOftenAsItsWeightSaysButForOne) {
  const std::vector<double> weights{0.05, 0.5, 0.15, 0.3};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng(seed);
    std::vector<int> count(4, 0);
    for (const std::size_t parent : resampled(weights, rng)) ++count[parent];
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GE(count[i], std::floor(4 * weights[i]));
      EXPECT_LE(count[i], std::ceil(4 * weights[i]));
    }
  }
}

TEST(Resampling, AParticleOfLittleWeightIsDrawnAsOftenAsItDeserves) {
  const std::vector<double> weights{0.05, 0.5, 0.15, 0.3};  // 0.2, 2, 0.6 and 1.2 copies
  constexpr int kDraws = 2000;
  std::vector<double> mean(4, 0.0);
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    Rng rng(seed);
    for (const std::size_t parent : resampled(weights, rng)) mean[parent] += 1.0 / kDraws;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    // A fraction of 4 w - floor(4 w) of the draws has one copy more: five standard errors.
    EXPECT_NEAR(mean[i], 4 * weights[i], 5 * 0.5 / std::sqrt(kDraws)) << i;
  }
}

}  // namespace
}  // namespace mapbed
