#include "bench/faults/skewed_sweeps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

// Beams to the left, ahead and to the right see 1, 2 and 3 m, and the robot does what `step` says
// in the second after the scan.
SensorLog one_scan(const Pose2& step) {
  LaserScan scan{.time = 0.0,
                 .first_bearing = 0.5 * kPi,
                 .bearing_step = -0.5 * kPi,
                 .max_range = 8.0,
                 .ranges = {1.0, 2.0, 3.0}};
  return {Odometry{0.0, {}}, scan, Odometry{1.0, step}};
}

std::vector<double> skewed(const SensorLog& log, const Trajectory& truth = {}) {
  return scans_of(with_skewed_sweeps(log, truth, {.duration = 1.0}).log)[0].ranges;
}

TEST(SkewedSweeps, ALaterBeamSeesWhatIsThereWhenTheRobotHasTurned) {
  // To the left by 90 degrees: the middle beam, after 45, looks between left and ahead; the last
  // one, at 90, sees what is ahead.
  const std::vector<double> ranges = skewed(one_scan({0.0, 0.0, 0.5 * kPi}));
  EXPECT_EQ(ranges[0], 1.0);
  EXPECT_TRUE(ranges[1] == 1.0 || ranges[1] == 2.0);
  EXPECT_EQ(ranges[2], 2.0);
}

TEST(SkewedSweeps, ABeamThatTurnsOutOfWhatTheScanSawFails) {
  EXPECT_EQ(skewed(one_scan({0.0, 0.0, -0.5 * kPi}))[2], 0.0);
}

TEST(SkewedSweeps, ALaterBeamIsShorterByTheWayTowardsWhatItSees) {
  // 0.4 m ahead in all: 0.2 m when the middle beam is taken; the last one looks across the way.
  const std::vector<double> ranges = skewed(one_scan({0.4, 0.0, 0.0}));
  EXPECT_THAT(ranges, ElementsAre(1.0, DoubleNear(1.8, 1e-12), DoubleNear(3.0, 1e-12)));
}

TEST(SkewedSweeps, TruthSaysHowTheRobotMovedWhereItIsKnown) {
  const Trajectory truth{{0.0, {5.0, 5.0, 1.0}}, {2.0, {5.0, 5.0, 1.0}}};  // stands
  EXPECT_THAT(skewed(one_scan({0.4, 0.0, 1.0}), truth),
              ElementsAre(DoubleNear(1.0, 1e-12), DoubleNear(2.0, 1e-12), DoubleNear(3.0, 1e-12)));
}

}  // namespace
}  // namespace mapbed
