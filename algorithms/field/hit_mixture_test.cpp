#include "algorithms/field/hit_mixture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

constexpr double kSigma = 0.1, kInliers = 0.8;
const HitMixture kMixture(kSigma, kInliers, 4.0, 512);

double formula(double d) {
  return std::log(kInliers * std::exp(-d * d / (2 * kSigma * kSigma)) + 1 - kInliers);
}

// The table's steps are 1/32 sigma^2. Its second derivative by d^2 / sigma^2 is at most 1/4 r (1 -
// r)
// <= 1/16 with r the Gaussian's part, and a line between two steps off by h^2 / 8 of that.
TEST(HitMixture, IsTheLogarithmOfGaussianAndUniform) {
  const double interpolation = 1.0 / 32 / 32 / 8 / 16;
  for (double d = 0.0; d < 3.99 * kSigma; d += 0.013) {
    const auto squared = static_cast<float>(d * d);
    EXPECT_NEAR(double{kMixture.log_at(squared)}, formula(d), interpolation + 1e-6) << d;
    EXPECT_EQ(kMixture.at(squared).log, kMixture.log_at(squared));
  }
}

TEST(HitMixture, IsThatOfAnOutlierFarAway) {
  for (const float squared : {0.17F, 1e9F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_FLOAT_EQ(kMixture.log_at(squared), static_cast<float>(std::log(1 - kInliers)));
    EXPECT_EQ(kMixture.at(squared).inlier, 0.0F);
  }
}

TEST(HitMixture, TellsHowLikelyABeamHitTheSurface) {
  EXPECT_NEAR(double{kMixture.at(0.0F).inlier}, kInliers, 1e-6);
  const double d = 0.15;
  const double gauss = kInliers * std::exp(-d * d / (2 * kSigma * kSigma));
  const double expected = gauss / (gauss + 1 - kInliers);
  EXPECT_NEAR(double{kMixture.at(static_cast<float>(d * d)).inlier}, expected, 1e-4);
  EXPECT_NEAR(kMixture.inlier_probability(formula(d)), expected, 1e-6);
}

TEST(InlierRatio, IsOneOnTheMapAndZeroOffIt) {
  const double off = 20 * kMixture.outlier_log();
  EXPECT_EQ(inlier_ratio(0.0, off), 1.0);
  EXPECT_EQ(inlier_ratio(off, off), 0.0);
}

}  // namespace
}  // namespace mapbed
