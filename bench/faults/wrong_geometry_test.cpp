#include "bench/faults/wrong_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

TEST(WrongGeometry, StatesAnotherStepAndLeavesTheFirstBeamWhereItWas) {
  const LaserScan scan = scans_of(with_wrong_geometry(small_log(), {.step = 0.1}, Rng(1)).log)[3];
  EXPECT_DOUBLE_EQ(scan.bearing_step, 0.55);
  EXPECT_EQ(scan.first_bearing, -0.5);
  EXPECT_EQ(scan.ranges, scans_of(small_log())[3].ranges);
}

TEST(WrongGeometry, StatesAnotherFirstBearingAndLeavesTheStep) {
  const LaserScan scan =
      scans_of(with_wrong_geometry(small_log(), {.first_bearing = 0.2}, Rng(1)).log)[3];
  EXPECT_DOUBLE_EQ(scan.first_bearing, -0.3);
  EXPECT_EQ(scan.bearing_step, 0.5);
}

}  // namespace
}  // namespace mapbed
