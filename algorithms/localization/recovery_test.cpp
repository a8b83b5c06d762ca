#include "algorithms/localization/recovery.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

TEST(LikelihoodMeans, DrawAnewWhereTheShortMeanFallsBelowTheLongOne) {
  LikelihoodMeans means({.slow = 0.0, .fast = 0.5, .most = 0.9});
  EXPECT_EQ(means.fraction_to_draw(), 0.0);
  means.add(0.8);
  EXPECT_EQ(means.fraction_to_draw(), 0.0);
  means.add(0.8);
  means.add(0.2);  // the long mean is that of all three, 0.6; the short one 0.5
  EXPECT_NEAR(means.fraction_to_draw(), 1.0 - 0.5 / 0.6, 1e-12);
  for (int i = 0; i < 10; ++i) means.add(0.9);
  EXPECT_EQ(means.fraction_to_draw(), 0.0);
}

TEST(LikelihoodMeans, NoMoreThanTheMost) {
  LikelihoodMeans means({.slow = 0.01, .fast = 1.0, .most = 0.3});
  for (int i = 0; i < 200; ++i) means.add(1.0);
  means.add(0.01);
  EXPECT_EQ(means.fraction_to_draw(), 0.3);
}

TEST(PlaceBelief, OneMeasurementMultipliesItsOdds) {
  PlaceBelief belief(0.5);
  // What may have changed since: 0.5 * (1 - 0.001) + 0.5 * 0.05.
  const double before = 0.5 * 0.999 + 0.5 * 0.05;
  belief.add(std::log(3.0));
  EXPECT_NEAR(belief.probability(), 3.0 * before / (3.0 * before + 1.0 - before), 1e-12);
}

TEST(PlaceBelief, IsNeverSoSureThatAFewContradictionsDoNotChangeIt) {
  PlaceBelief belief(0.5);
  for (int i = 0; i < 1000; ++i) belief.add(10.0);
  for (int i = 0; i < 4; ++i) belief.add(-3.0);
  EXPECT_LT(belief.probability(), 0.5);
  for (int i = 0; i < 1000; ++i) belief.add(-10.0);
  for (int i = 0; i < 4; ++i) belief.add(3.0);
  EXPECT_GT(belief.probability(), 0.95);
}

TEST(PlaceBelief, OfAnotherPlaceNothingIsBelievedYet) {
  PlaceBelief belief(0.95);
  belief.doubt();
  EXPECT_EQ(belief.probability(), 0.5);
  PlaceBelief doubted(0.1);
  doubted.doubt();
  EXPECT_EQ(doubted.probability(), 0.1);
}

}  // namespace
}  // namespace mapbed
