#include "algorithms/input/repeated_scans.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

LaserScan scan_at(double time, std::vector<double> ranges, int laser = 0) {
  return {.time = time,
          .laser = laser,
          .bearing_step = 0.1,
          .max_range = 8.0,
          .ranges = std::move(ranges)};
}

Odometry odometry_at(double time, const Pose2& pose) {
  return {.time = time, .odometry_from_robot = pose};
}

TEST(RepeatedScans, AreNoMeasurementOfARobotThatMoves) {
  RepeatedScans repeated;
  for (int i = 0; i < 10; ++i) {
    repeated.add(odometry_at(i, {0.5 * i, 0.0, 0.0}));
    const bool hangs = i >= 4 && i < 7;
    const double range = hangs ? 2.3 : 2.0 + 0.1 * i;
    const LaserScan scan = repeated.checked(scan_at(i, {range, 3.0, 8.0}));
    EXPECT_EQ(scan.ranges.empty(), hangs) << i;
    EXPECT_EQ(scan.time, i);
  }
  const std::vector<Remark> remarks = repeated.remarks(0.0);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0].kind, RemarkKind::repeated_scan);
  EXPECT_EQ(remarks[0].when, (TimeInterval{4.0, 6.0}));
}

TEST(RepeatedScans, AreNoMeasurementOfARobotThatTurns) {
  RepeatedScans repeated;
  repeated.add(odometry_at(0.0, {}));
  repeated.checked(scan_at(0.0, {1.0, 2.0}));
  repeated.add(odometry_at(1.0, {0.0, 0.0, 0.3}));
  EXPECT_TRUE(repeated.checked(scan_at(1.0, {1.0, 2.0})).ranges.empty());
}

TEST(RepeatedScans, MayBeSeenByARobotThatStands) {
  RepeatedScans repeated;
  for (int i = 0; i < 5; ++i) {
    repeated.add(odometry_at(i, {1.0, 2.0, 0.5}));
    EXPECT_FALSE(repeated.checked(scan_at(i, {1.0, 2.0})).ranges.empty());
  }
  EXPECT_TRUE(repeated.remarks(0.0).empty());
}

TEST(RepeatedScans, MayBeSeenWhereNobodyKnowsWhetherTheRobotMoves) {
  RepeatedScans repeated;
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(repeated.checked(scan_at(i, {1.0, 2.0})).ranges.empty());
  }
  EXPECT_TRUE(repeated.remarks(0.0).empty());
}

TEST(RepeatedScans, OfALaserThatSeesNothingTellNothing) {
  RepeatedScans repeated;
  for (int i = 0; i < 5; ++i) {
    repeated.add(odometry_at(i, {0.5 * i, 0.0, 0.0}));
    EXPECT_FALSE(repeated.checked(scan_at(i, {8.0, 0.0, 8.0})).ranges.empty());
  }
  EXPECT_TRUE(repeated.remarks(0.0).empty());
}

TEST(RepeatedScans, AreOfOneLaserAlone) {
  RepeatedScans repeated;
  for (int i = 0; i < 4; ++i) {
    repeated.add(odometry_at(i, {0.5 * i, 0.0, 0.0}));
    const double own = 1.0 + 0.1 * i;
    EXPECT_EQ(repeated.checked(scan_at(i, {2.0}, 0)).ranges.empty(), i > 0);
    EXPECT_FALSE(repeated.checked(scan_at(i, {own}, 1)).ranges.empty());
  }
  EXPECT_EQ(repeated.remarks(0.0).size(), 1U);
}

}  // namespace
}  // namespace mapbed
