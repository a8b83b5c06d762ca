#include "algorithms/scan_matching/local_scans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

const TestLaser kAllRound{
    .beams = 1440, .first_bearing = -kPi, .bearing_step = radians(0.25), .max_range = 8.0};

LocalScans of_one_scan(const TestRoom& room) {
  LocalScans scans({}, {}, 30.0);
  scans.remember(scan_of(room, {}, kAllRound), {});
  return scans;
}

// Walls 1 m to either side, whose farthest hit is 7.9 m ahead: their next hits
// would say that the robot is still behind.
TEST(LocalScans, DoNotKnowTheGroundBeyondWhereWallsWereSeen) {
  const LocalScans scans = of_one_scan(corridor(60.0));
  const std::vector<Eigen::Vector2d> hits = {{3.0, 1.0}, {8.2, 1.0}, {8.2, -1.0}, {20.0, 1.0}};
  EXPECT_THAT(scans.known(hits, {}, {}), ElementsAre(true, false, false, false));
}

TEST(LocalScans, KnowAClosedRoomAndThatNoBeamLeavesIt) {
  const LocalScans scans = of_one_scan(rectangular_room(6.0, 6.0));
  const std::vector<Eigen::Vector2d> hits = {{3.0, 0.0}, {3.2, 0.0}, {3.4, 1.0}, {2.0, 1.0}};
  EXPECT_THAT(scans.known(hits, {}, {}), ElementsAre(true, true, true, true));
}

TEST(LocalScans, KnowNothingOnceThePastIsForgotten) {
  LocalScans scans = of_one_scan(rectangular_room(6.0, 6.0));
  scans.forget_past(true);
  EXPECT_FALSE(scans.empty());
  scans.forget_past(false);
  EXPECT_TRUE(scans.empty());
  EXPECT_THAT(scans.known({{3.0, 0.0}}, {}, {}), ElementsAre(false));
}

}  // namespace
}  // namespace mapbed
