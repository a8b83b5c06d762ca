#include "bench/faults/turned_mount.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

TEST(TurnedMount, TurnsTheStatedHeadingOfEveryLaser) {
  const BrokenLog broken = with_turned_mount(small_log(), {.angle = 0.1}, Rng(1));
  for (const LaserScan& scan : scans_of(broken.log)) {
    EXPECT_EQ(scan.robot_from_laser.planar, (Pose2{0.0, 0.0, 0.1}));
  }
  EXPECT_THAT(broken.when, ::testing::ElementsAre(TimeInterval{100.0, 109.0}));
}

}  // namespace
}  // namespace mapbed
