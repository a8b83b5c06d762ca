#include "algorithms/input/scan_agreement.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

const TestLaser kAllRound{.beams = 360, .first_bearing = -kPi, .max_range = 20.0};
const Bearings kRight{-kPi, radians(1.0)};
const Bearings kHalfCircle{-0.5 * kPi, radians(0.5)};

// A robot that turns by 20 degrees between its scans.
SensorLog turning(const TestLaser& laser) {
  SensorLog log;
  for (int i = 0; i < 30; ++i) {
    const Pose2 pose{0.4, 0.3, radians(20.0) * i};
    log.emplace_back(Odometry{.time = 1.0 * i, .odometry_from_robot = pose});
    log.emplace_back(scan_of(l_shaped_room(), pose, laser, 1.0 * i));
  }
  return log;
}

TEST(ScanAgreement, IsHighForTheRightBearingsAlone) {
  const SensorLog log = turning(kAllRound);
  const std::vector<ScanPair> pairs = scan_pairs(log, 0, 360, 100);
  ASSERT_EQ(pairs.size(), 29U);
  const AgreementComparison both = compare(pairs, {kRight, kHalfCircle});
  EXPECT_GT(both.mean[0], 0.9);
  EXPECT_TRUE(is_clearly_better(both, 0, 1));
  EXPECT_FALSE(is_clearly_better(both, 1, 0));
}

TEST(ScanAgreement, OfFewPairsTellsNothing) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_clearly_better({{1.0, 0.0}, {{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}}}, 0, 1));
  EXPECT_FALSE(is_clearly_better(
      {{1.0, 0.0}, {std::vector<double>(20, 1.0), std::vector<double>(20, none)}}, 0, 1));
}

// First and last beam of a full circle are neighbours; those of half a circle look at two walls.
TEST(ScanAgreement, SeesWhetherTheEndsMeet) {
  const SensorLog circle = turning(kAllRound);
  EXPECT_TRUE(ends_meet(scan_pairs(circle, 0, 360, 100)));
  const SensorLog half = turning({.beams = 181, .max_range = 20.0});
  EXPECT_FALSE(ends_meet(scan_pairs(half, 0, 181, 100)));
}

TEST(ScanAgreement, IsOfPairsThatAreNotFarApartInTime) {
  SensorLog log = turning(kAllRound);
  for (Measurement& measurement : log) {
    std::visit([](auto& m) { m.time *= 10.0; }, measurement);
  }
  EXPECT_TRUE(scan_pairs(log, 0, 360, 100).empty());
}

}  // namespace
}  // namespace mapbed
