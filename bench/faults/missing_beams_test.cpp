#include "bench/faults/missing_beams.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

TEST(MissingBeams, FailInThatFractionOfCases) {
  constexpr int kScans = 10'000;
  const BrokenLog broken = with_missing_beams(small_log(kScans - 1), {.fraction = 0.7}, Rng(1));
  int failed = 0;
  for (const LaserScan& scan : scans_of(broken.log)) {
    for (const double range : scan.ranges) failed += range <= 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(failed, 0.7 * 3 * kScans, 5.0 * std::sqrt(3 * kScans * 0.7 * 0.3));
}

TEST(MissingBeams, LeaveTheOthersAsTheyAre) {
  const std::vector<LaserScan> scans =
      scans_of(with_missing_beams(small_log(), {.fraction = 0.5}, Rng(1)).log);
  const std::vector<LaserScan> clean = scans_of(small_log());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (std::size_t beam = 0; beam < 3; ++beam) {
      const double range = scans[i].ranges[beam];
      EXPECT_TRUE(range == 0.0 || range == clean[i].ranges[beam]);
    }
  }
}

}  // namespace
}  // namespace mapbed
