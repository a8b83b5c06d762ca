#include "bench/faults/reordered_stamps.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

TEST(ReorderedStamps, ChangeNeighbouringScans) {
  const BrokenLog broken = with_reordered_stamps(small_log(3), {.fraction = 1.0}, Rng(1));
  std::vector<double> first_ranges;
  for (const LaserScan& scan : scans_of(broken.log)) first_ranges.push_back(scan.ranges[0]);
  EXPECT_THAT(first_ranges, ElementsAre(2, 1, 4, 3));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(scans_of(broken.log)[static_cast<std::size_t>(i)].time, 100.0 + i);
  }
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{100.0, 103.0}));
}

TEST(ReorderedStamps, AreOfThatFractionOfScans) {
  constexpr int kScans = 20'000;
  const BrokenLog broken = with_reordered_stamps(small_log(kScans - 1), {.fraction = 0.2}, Rng(1));
  const std::vector<LaserScan> scans = scans_of(broken.log);
  int changed = 0;
  for (int i = 0; i < kScans; ++i) {
    changed += scans[static_cast<std::size_t>(i)].ranges[0] == 1.0 + i ? 0 : 1;
  }
  // Pairs: their number has less than the binomial's spread, each counts twice. Five of those.
  EXPECT_NEAR(changed, 0.2 * kScans, 2.0 * 5.0 * std::sqrt(kScans * 0.1 * 0.9));
}

}  // namespace
}  // namespace mapbed
