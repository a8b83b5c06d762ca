#include "core/random.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/statistics/moments.h"

namespace mapbed {
namespace {

TEST(Rng, TheSameSeedGivesTheSameNumbers) {
  Rng a(7), b(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Rng, AStreamDoesNotDependOnHowMuchOfItsParentWasUsed) {
  Rng used(7);
  for (int i = 0; i < 13; ++i) used.normal();
  EXPECT_EQ(used.stream("laser").bits(), Rng(7).stream("laser").bits());
}

TEST(Rng, StreamsOfOtherNamesAndNumbersDiffer) {
  const Rng rng(7);
  EXPECT_NE(rng.stream("laser").bits(), rng.stream("odometry").bits());
  EXPECT_NE(rng.stream("person", 1).bits(), rng.stream("person", 2).bits());
  EXPECT_NE(rng.stream("person", 1, 2).bits(), rng.stream("person", 2, 1).bits());
  EXPECT_NE(rng.stream("person", 1, 2).bits(), rng.stream("person", 1, 3).bits());
  EXPECT_NE(rng.stream("person", 1, 2).bits(), rng.stream("person", 3, 2).bits());
}

TEST(Rng, NormalsHaveMeanZeroAndSigmaOne) {
  constexpr int n = 100'000;
  Rng rng(42);
  Moments found;
  for (int i = 0; i < n; ++i) found.add(rng.normal());
  EXPECT_NEAR(found.mean(), 0.0, 5.0 / std::sqrt(n));  // five standard errors
  EXPECT_NEAR(found.sigma(), 1.0, 5.0 / std::sqrt(2.0 * n));
}

TEST(Rng, IndexReachesEveryNumberBelowItsBoundEquallyOften) {
  constexpr int n = 60'000;
  Rng rng(1);
  int count[6] = {};
  for (int i = 0; i < n; ++i) ++count[rng.index(6)];
  for (const int c : count) EXPECT_NEAR(c, n / 6.0, 5 * std::sqrt(n * (1 / 6.0) * (5 / 6.0)));
}

}  // namespace
}  // namespace mapbed
