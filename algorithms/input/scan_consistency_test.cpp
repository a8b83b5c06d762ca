#include "algorithms/input/scan_consistency.h"

#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "algorithms/testing/furnished_room.h"

namespace mapbed {
namespace {

std::vector<Eigen::Vector2d> points_at(const Pose2& pose, double step_error = 0.0) {
  LaserScan scan = scan_of(furnished_room(), pose, {.max_range = 20.0});
  scan.bearing_step += step_error;
  return all_hit_points(scan, 20.0);
}

const Pose2 kFrom{0.0, 0.0, 0.0}, kTo{0.3, 0.1, 0.2};

TEST(ScanConsistency, ScansOfOnePlaceLieOnEachOther) {
  EXPECT_LT(mismatch(points_at(kFrom), points_at(kTo), motion_between(kFrom, kTo)), 0.03);
}

TEST(ScanConsistency, ATurnThatIsNotKnownOrBearingsThatAreWrongAreSeen) {
  const double right = mismatch(points_at(kFrom), points_at(kTo), motion_between(kFrom, kTo));
  const Pose2 not_turned{0.3, 0.1, 0.0};
  EXPECT_GT(mismatch(points_at(kFrom), points_at(kTo), not_turned), 3.0 * right);
  // A half circle that is taken for 200 degrees.
  const double step = radians(20.0) / 180.0;
  EXPECT_GT(mismatch(points_at(kFrom, step), points_at(kTo, step), motion_between(kFrom, kTo)),
            1.5 * right);
}

TEST(ScanConsistency, WhatOneScanAloneSawCountsUpToTheReach) {
  EXPECT_DOUBLE_EQ(mismatch({{0.0, 0.0}}, {{100.0, 0.0}}, {}, 0.3), 0.3);
  EXPECT_DOUBLE_EQ(mismatch({}, {{1.0, 0.0}}, {}, 0.3), 0.3);
}

}  // namespace
}  // namespace mapbed
