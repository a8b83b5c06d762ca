#include "bench/faults/carried_away.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

constexpr Tolerance kRounding{1e-12, 1e-12};  // [m], [rad]

TEST(CarriedAway, TheLogHasAGapAndOdometryKnowsNothingOfIt) {
  const BrokenLog broken = with_carried_away(small_log(), {.duration = 3.0, .at = {2.0}}, Rng(1));
  std::vector<double> stamps;
  for (const LaserScan& scan : scans_of(broken.log)) stamps.push_back(scan.time - 100.0);
  EXPECT_THAT(stamps, ElementsAre(0, 1, 2, 5, 6, 7, 8, 9));
  const std::vector<Odometry> readings = readings_of(broken.log);
  EXPECT_EQ(readings[2].odometry_from_robot, (Pose2{2.0, 0.0, 0.0}));
  EXPECT_THAT(readings[3].odometry_from_robot, IsNear(Pose2{2.0, 0.0, 0.0}, kRounding));
  EXPECT_THAT(readings[4].odometry_from_robot, IsNear(Pose2{3.0, 0.0, 0.0}, kRounding));
  EXPECT_THAT(readings[7].odometry_from_robot, IsNear(Pose2{3.0, 0.0, 3.0}, kRounding));
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{102.0, 105.0}));
}

}  // namespace
}  // namespace mapbed
