#include "core/statistics/chi_square.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/statistics/moments.h"

namespace mapbed {
namespace {

TEST(ChiSquare, IsTheSumOfSquaresOverTheExpectation) {
  const std::array observed{12.0, 18.0, 30.0};
  const std::array expected{20.0, 20.0, 20.0};
  const ChiSquare result = chi_square(observed, expected);
  EXPECT_DOUBLE_EQ(result.value, (64.0 + 4.0 + 100.0) / 20.0);
  EXPECT_EQ(result.freedoms, 2);
}

TEST(ChiSquare, TheScoreIsThatOfTheNormalDistribution) {
  // Tables: chi-square of 10 freedoms is below 18.307 with 95 %, of 30 below 59.703 with 99.9 %.
  const auto score = [](int freedoms, double value) {
    std::vector<double> expected(static_cast<std::size_t>(freedoms) + 1, 100.0);
    std::vector<double> observed = expected;
    observed[0] += std::sqrt(value * 100.0);
    return chi_square(observed, expected).score;
  };
  EXPECT_NEAR(score(10, 18.307), 1.645, 0.01);
  EXPECT_NEAR(score(30, 59.703), 3.090, 0.02);
}

TEST(ChiSquare, ThinClassesArePutTogether) {
  const std::array observed{50.0, 1.0, 2.0, 3.0, 1.0};
  const std::array expected{50.0, 2.0, 2.0, 2.0, 1.0};
  const ChiSquare result = chi_square(observed, expected);
  EXPECT_EQ(result.classes, 2);  // 50, and 2 + 2 + 2 with the rest of 1
  EXPECT_DOUBLE_EQ(result.observed, 57.0);
  EXPECT_DOUBLE_EQ(result.value, 0.0);
}

TEST(ChiSquare, OneClassHasNothingToBeComparedWith) {
  const ChiSquare result = chi_square(std::array{3.0}, std::array{3.0});
  EXPECT_EQ(result.freedoms, 0);
  EXPECT_EQ(result.score, 0.0);
}

TEST(ChiSquare, ScoresOfRightExpectationsAreStandardNormal) {
  constexpr int kTrials = 2000;
  Rng rng(3);
  Moments scores;
  const std::vector<double> expected(11, 20.0);
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> observed(expected.size(), 0.0);
    for (int i = 0; i < 220; ++i) observed[rng.index(observed.size())] += 1.0;
    scores.add(chi_square(observed, expected).score);
  }
  EXPECT_NEAR(scores.mean(), 0.0, 5.0 / std::sqrt(kTrials));
  EXPECT_NEAR(scores.variance(), 1.0, 5.0 * std::sqrt(2.0 / kTrials));
}

}  // namespace
}  // namespace mapbed
