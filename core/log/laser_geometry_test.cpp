#include "core/log/laser_geometry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

// A pile at the top as it is meant: counted value by value over the upper half of the scale.
std::optional<double> pile_by_counting(const LaserScan& scan) {
  const double top = *std::max_element(scan.ranges.begin(), scan.ranges.end());
  std::map<double, int> counts;
  for (const double r : scan.ranges)
    if (r > 0.5 * top) ++counts[r];
  std::optional<double> best;
  for (const auto& [r, count] : counts)
    if (!best || count >= counts[*best]) best = r;
  if (!best || *best < 0.99 * top || counts[*best] < 10) return {};
  for (const auto& [r, count] : counts)
    if (r != *best && 10 * count > counts[*best]) return {};
  return best;
}

TEST(MaxRange, IsThePileAtTheTopThatCountingFinds) {
  Rng rng(1);
  int piles = 0;
  for (int trial = 0; trial < 400; ++trial) {
    LaserScan scan;
    scan.ranges.resize(200);
    const double steps = 1.0 + std::floor(300.0 * rng.uniform());
    const double share = rng.uniform();
    for (double& r : scan.ranges)
      r = rng.uniform() < share ? 10.0 : 0.05 + std::floor(steps * rng.uniform()) * 10.0 / steps;
    const auto pile = pile_by_counting(scan);
    piles += pile.has_value() ? 1 : 0;
    EXPECT_EQ(max_range_of({&scan}, 29.0), pile.value_or(29.0)) << trial;
  }
  EXPECT_GT(piles, 50);
  EXPECT_LT(piles, 350);
}

// A robot in front of a wall: its readings are a pile, too.
TEST(MaxRange, IsWhatIsStatedWhereInfiniteReadingsSayWhatIsNone) {
  LaserScan scan;
  scan.ranges.assign(200, 5.0);
  EXPECT_EQ(max_range_of({&scan}, 8.0), 5.0);
  scan.ranges.push_back(INFINITY);
  EXPECT_EQ(max_range_of({&scan}, 8.0), 8.0);
  EXPECT_EQ(max_range_of({&scan}, 0.0), 5.0);
}

}  // namespace
}  // namespace mapbed
