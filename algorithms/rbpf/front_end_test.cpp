#include "algorithms/rbpf/front_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/rbpf/testing/drives.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

const TestLaser kLaser{.beams = 361, .first_bearing = -kPi, .max_range = 15.0};
const Pose2 kStart{-3.0, -2.0, 0.0};
// Of a match without range noise: half of a cell of the matcher's map at most.
const Tolerance kMatched{0.025, 0.01};
const Tolerance kExact{1e-9, 1e-9};

// Straight on in the furnished room. Odometry says a tenth too much, so that what comes from it can
// be told from what the scans say.
class Drive {
 public:
  explicit Drive(const FrontEndOptions& options) : front_end(options) {}

  FrontEnd::Result step(double way, const Pose2& missed = {},
                        const TestRoom& seen = furnished_room()) {
    odometry = odometry * Pose2{1.1 * way, 0.0, 0.0};
    truth = truth * Pose2{way, 0.0, 0.0} * missed;
    time += 1.0;
    front_end.add(Odometry{.time = time, .odometry_from_robot = odometry});
    return front_end.add(scan_of(seen, truth, kLaser, time));
  }

  FrontEnd front_end;
  Pose2 odometry, truth = kStart;
  double time = 0.0;  // [s]
};

TEST(FrontEnd, TheFirstScanMakesAnUpdateWithoutAMotion) {
  Drive drive({});
  const FrontEnd::Result first = drive.step(0.0);
  ASSERT_TRUE(first.update);
  EXPECT_EQ(first.update->whole, Pose2{});
  EXPECT_FALSE(first.step);
  EXPECT_EQ(drive.front_end.updates().size(), 1U);
}

TEST(FrontEnd, CondensesAllScansButTheNewestOne) {
  Drive drive({.proposal = Proposal::scan_matching, .update_distance = 0.5});
  drive.step(0.0);
  EXPECT_FALSE(drive.step(0.2).update);
  EXPECT_FALSE(drive.step(0.2).update);
  const FrontEnd::Result due = drive.step(0.2);
  ASSERT_TRUE(due.update);
  const Pose2 by_odometry{0.22, 0.0, 0.0};
  EXPECT_THAT(due.update->condensed, IsNear(Pose2{0.4, 0.0, 0.0}, kMatched));
  EXPECT_THAT(*due.update->step, IsNear(by_odometry, kExact));
  EXPECT_DOUBLE_EQ(due.update->seconds, 1.0);
  EXPECT_THAT(due.update->guess, IsNear(Pose2{0.6, 0.0, 0.0}, kMatched));
  // The update's own scan weights, so it has no say in the motion.
  EXPECT_THAT(due.update->whole, IsNear(due.update->condensed * by_odometry, kExact));
  const FrontEnd::Update& update = drive.front_end.updates().back();
  EXPECT_TRUE(update.is_condensed);
  EXPECT_EQ(update.condensed, due.update->condensed);
  EXPECT_DOUBLE_EQ(update.condensed_until, drive.time - 1.0);
}

TEST(FrontEnd, GoesOnFromTheLastMatchedScanAfterAnUpdate) {
  Drive drive({.proposal = Proposal::scan_matching, .update_distance = 0.5});
  for (const double way : {0.0, 0.2, 0.2, 0.2, 0.2, 0.2}) drive.step(way);
  const FrontEnd::Result due = drive.step(0.2);
  ASSERT_TRUE(due.update);
  EXPECT_THAT(due.update->condensed, IsNear(Pose2{0.4, 0.0, 0.0}, kMatched));
  EXPECT_THAT(drive.front_end.scans().back().track_from_robot,
              IsNear(Pose2{1.2, 0.0, 0.0}, kMatched));
}

TEST(FrontEnd, WhereEachScanIsAnUpdateOdometryAloneIsThePrior) {
  Drive drive({.proposal = Proposal::improved, .update_distance = 0.5});
  drive.step(0.0);
  for (int i = 0; i < 3; ++i) {
    const FrontEnd::Result due = drive.step(0.6);
    ASSERT_TRUE(due.update);
    EXPECT_EQ(due.update->condensed, Pose2{});
    EXPECT_THAT(*due.update->step, IsNear(Pose2{0.66, 0.0, 0.0}, kExact));
    EXPECT_THAT(due.update->guess, IsNear(Pose2{0.6, 0.0, 0.0}, kMatched));
    EXPECT_FALSE(drive.front_end.updates().back().is_condensed);
  }
}

TEST(FrontEnd, TheStandardFilterMovesByOdometryAlone) {
  Drive drive({.proposal = Proposal::odometry, .update_distance = 0.5});
  drive.step(0.0);
  EXPECT_FALSE(drive.step(0.4).update);
  const FrontEnd::Result due = drive.step(0.4);
  ASSERT_TRUE(due.update);
  EXPECT_THAT(due.update->whole, IsNear(Pose2{0.88, 0.0, 0.0}, kExact));
  EXPECT_THAT(drive.front_end.scans().back().track_from_robot, IsNear(drive.odometry, kExact));
}

TEST(FrontEnd, ATurnMakesAnUpdateToo) {
  Drive drive({.update_turn = 0.4});
  drive.step(0.0);
  EXPECT_FALSE(drive.step(0.0, {0.0, 0.0, 0.3}).update);
  EXPECT_TRUE(drive.step(0.0, {0.0, 0.0, 0.15}).update);
}

TEST(FrontEnd, SaysWhereAScanRefutesOdometry) {
  Drive drive({.update_distance = 0.5});
  drive.step(0.0);
  drive.step(0.2);
  EXPECT_FALSE(drive.step(0.4).update->step_contradicted);
  drive.step(0.2);
  const FrontEnd::Result due = drive.step(0.4, {0.0, 0.0, 1.5});  // the wheels saw no turn
  ASSERT_TRUE(due.update);
  EXPECT_TRUE(due.update->step_contradicted);
  EXPECT_THAT(due.update->guess, IsNear(Pose2{0.6, 0.0, 1.5}, kMatched));
  EXPECT_TRUE(drive.front_end.newest_is_matched());
}

TEST(FrontEnd, AfterAScanThatFitsNowhereOdometryAloneTellsTheMotionSinceTheUpdate) {
  const TestRoom another = rectangular_room(5.0, 26.0);
  Drive drive({.update_distance = 0.5});
  for (const double way : {0.0, 0.2, 0.2}) drive.step(way);
  ASSERT_TRUE(drive.step(0.2).update);
  drive.step(0.2, {}, another);
  ASSERT_FALSE(drive.front_end.newest_is_matched());
  const FrontEnd::Result due = drive.step(0.3);
  ASSERT_TRUE(due.update);
  EXPECT_EQ(due.update->condensed, Pose2{});
  EXPECT_THAT(*due.update->step, IsNear(Pose2{1.1 * 0.5, 0.0, 0.0}, kExact));
  EXPECT_TRUE(due.update->guess_is_doubtful);
  EXPECT_FALSE(drive.front_end.updates().back().is_condensed);
}

TEST(FrontEnd, MatchesWithTheNewestScanAloneOnceThePastIsForgotten) {
  Drive drive({.update_distance = 0.5});
  for (const double way : {0.0, 0.6, 0.6}) drive.step(way);
  drive.front_end.forget_past();
  EXPECT_THAT(drive.step(0.6).update->guess, IsNear(Pose2{0.6, 0.0, 0.0}, kMatched));
  EXPECT_TRUE(drive.front_end.newest_is_matched());
}

TEST(FrontEnd, HasNothingToMatchWithWhereTheNewestScanWasWithheld) {
  Drive drive({.update_distance = 0.5});
  for (const double way : {0.0, 0.2, 0.4}) drive.step(way);
  drive.front_end.forget_past();
  drive.step(0.2);
  EXPECT_FALSE(drive.front_end.newest_is_matched());
}

}  // namespace
}  // namespace mapbed
