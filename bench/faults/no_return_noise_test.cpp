#include "bench/faults/no_return_noise.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

TEST(NoReturnNoise, MakesHitsJustBelowTheLargestRangeOfBeamsWithoutReturn) {
  const NoReturnNoiseOptions options{.fraction = 1e-9, .below = 0.05};
  for (const LaserScan& scan : scans_of(with_no_return_noise(small_log(), options, Rng(1)).log)) {
    EXPECT_EQ(scan.ranges[1], 2.0);
    EXPECT_GE(scan.ranges[2], 7.95);
    EXPECT_TRUE(scan.is_hit(2));
  }
}

TEST(NoReturnNoise, TakesTheReturnFromThatFractionOfBeams) {
  constexpr int kScans = 10'000;
  const BrokenLog broken = with_no_return_noise(small_log(kScans - 1), {.fraction = 0.1}, Rng(1));
  int without = 0;
  for (const LaserScan& scan : scans_of(broken.log)) without += scan.ranges[1] > 7.0 ? 1 : 0;
  EXPECT_NEAR(without, 0.1 * kScans, 5.0 * std::sqrt(kScans * 0.1 * 0.9));
}

}  // namespace
}  // namespace mapbed
