#include "bench/faults/repeated_scans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

TEST(RepeatedScans, AreTheLastOneByteForByteWithNewStamps) {
  const RepeatedScansOptions options{.duration = 2.5, .at = {2.0}};
  const BrokenLog broken = with_repeated_scans(small_log(), options, Rng(1));
  const std::vector<LaserScan> scans = scans_of(broken.log);
  std::vector<double> first_ranges;  // 1 m + the second of the scan, where it is its own
  for (const LaserScan& scan : scans) first_ranges.push_back(scan.ranges[0]);
  EXPECT_THAT(first_ranges, ElementsAre(1, 2, 3, 3, 3, 6, 7, 8, 9, 10));
  EXPECT_EQ(scans[4].time, 104.0);
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{102.0, 104.5}));
}

TEST(RepeatedScans, AreOfEachLaserItsOwn) {
  SensorLog log;
  for (int i = 0; i < 4; ++i) {
    for (int laser = 0; laser < 2; ++laser) {
      log.push_back(LaserScan{
          .time = 1.0 * i, .laser = laser, .max_range = 8.0, .ranges = {1.0 + laser + 0.1 * i}});
    }
  }
  const BrokenLog broken = with_repeated_scans(log, {.duration = 10.0, .at = {0.0}}, Rng(1));
  const std::vector<LaserScan> scans = scans_of(broken.log);
  EXPECT_EQ(scans[6].ranges[0], 1.0);
  EXPECT_EQ(scans[7].laser, 1);
  EXPECT_EQ(scans[7].ranges[0], 2.0);
}

}  // namespace
}  // namespace mapbed
