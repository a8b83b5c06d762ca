#include "bench/faults/dropped_scans.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

TEST(DroppedScans, AreThatFractionOfThem) {
  constexpr int kScans = 10'000;
  const BrokenLog broken = with_dropped_scans(small_log(kScans - 1), {.fraction = 0.6}, Rng(1));
  const double left = static_cast<double>(scans_of(broken.log).size());
  // Binomial: five standard deviations.
  EXPECT_NEAR(left, 0.4 * kScans, 5.0 * std::sqrt(kScans * 0.4 * 0.6));
  EXPECT_EQ(readings_of(broken.log).size(), kScans) << "odometry stays";
}

TEST(DroppedScans, AreNotTheFirstOne) {
  const std::vector<LaserScan> left =
      scans_of(with_dropped_scans(small_log(), {.fraction = 1.0}, Rng(1)).log);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].time, 100.0);
}

}  // namespace
}  // namespace mapbed
