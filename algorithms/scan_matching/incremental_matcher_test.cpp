#include "algorithms/scan_matching/incremental_matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/odometry_estimator.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// A round through the ring corridor, 8 m from corner to corner.
RecordedLog round_trip(std::uint64_t seed) {
  DriveOptions drive;
  drive.laser.max_range = 20.0;
  TestRoom room = ring_corridor();
  room.add_box({3.0, -4.3}, 0.4, 0.3);  // so that no corridor is bare
  room.add_box({4.4, 2.0}, 0.3, 0.5);
  room.add_box({-1.0, 4.4}, 0.6, 0.3);
  room.add_box({-4.4, -1.0}, 0.3, 0.6);
  return drive_through(room, {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {-5, -4}}, drive, Rng(seed));
}

// The largest position error, both paths beginning at the same pose [m].
double largest_error(const RecordedLog& log, const Estimate& estimate) {
  const Pose2 first = *pose_at(log.true_poses, estimate.trajectory.front().time);
  double largest = 0.0;
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    const Pose2 truth = motion_between(first, *pose_at(log.true_poses, stamped.time));
    largest = std::max(
        largest, distance(truth, motion_between(estimate.trajectory.front().pose, stamped.pose)));
  }
  return largest;
}

Estimate run(const RecordedLog& log, const IncrementalMatcherOptions& options) {
  IncrementalMatcher matcher(options);
  for (const Measurement& measurement : log.measurements) matcher.add(measurement);
  return matcher.estimate();
}

TEST(IncrementalMatcher, StaysNearTheTruePathWhereOdometryDriftsAway) {
  const RecordedLog log = round_trip(5);
  OdometryEstimator odometry;
  for (const Measurement& measurement : log.measurements) odometry.add(measurement);
  const double drift = largest_error(log, odometry.estimate());
  EXPECT_GT(drift, 0.6);
  EXPECT_LT(largest_error(log, run(log, {})), drift / 3.0);
}

// Nothing in view tells how far the robot came along a bare corridor; what the laser newly sees of
// its walls, beyond the map, must not count as if it did.
TEST(IncrementalMatcher, KeepsTheLengthOfABareCorridor) {
  const RecordedLog log = drive_through(corridor(60.0), {{-20, 0}, {20, 0}}, {}, Rng(7));
  OdometryEstimator odometry;
  for (const Measurement& measurement : log.measurements) odometry.add(measurement);
  const auto length = [](const Estimate& estimate) {
    return distance(estimate.trajectory.front().pose, estimate.trajectory.back().pose);
  };
  EXPECT_NEAR(length(run(log, {})), length(odometry.estimate()), 0.4);  // 1 %
}

// Without odometry nothing tells how far the robot came, and it says so; not where posts do.
TEST(IncrementalMatcher, TellsThatItDoesNotKnowTheWayAlongABareCorridor) {
  const auto told = [](const TestRoom& room) {
    const Estimate estimate =
        run(drive_through(room, {{-4, 0}, {4, 0}}, {}, Rng(7)), {.use_odometry = false});
    return std::any_of(estimate.remarks.begin(), estimate.remarks.end(), [](const Remark& remark) {
      return remark.kind == RemarkKind::unknown_motion;
    });
  };
  TestRoom with_posts = corridor(60.0);
  for (int i = -8; i <= 8; ++i) with_posts.add_box({1.5 * i, i % 2 == 0 ? 0.9 : -0.9}, 0.2, 0.2);
  EXPECT_TRUE(told(corridor(60.0)));
  EXPECT_FALSE(told(with_posts));
}

// Along it, no more is known than that the robot went on: ten scans of 0.1 s, each with its own
// change of speed. Across, scans tell.
TEST(IncrementalMatcher, KnowsLittleOfAMotionAlongABareCorridor) {
  const RecordedLog log = drive_through(corridor(60.0), {{-4, 0}, {4, 0}}, {}, Rng(7));
  const auto at_the_end = [&](const IncrementalMatcherOptions& options) {
    IncrementalMatcher matcher(options);
    for (const Measurement& measurement : log.measurements) matcher.add(measurement);
    return matcher.blind_spread(10, 1.0);
  };
  const std::optional<Eigen::Matrix3d> spread = at_the_end({.use_odometry = false});
  ASSERT_TRUE(spread);
  const MotionPriorOptions motion;
  const double by_time = std::sqrt(10.0) * (motion.position_sigma + motion.speed_sigma * 0.1);
  EXPECT_NEAR(std::sqrt((*spread)(0, 0)), by_time, 0.2 * by_time);
  EXPECT_LT(std::sqrt((*spread)(1, 1)), 0.02);
  EXPECT_FALSE(at_the_end({.use_odometry = true}));
}

// Odometry stands still for a second while the robot turns by 90 degrees in a room that looks alike
// from there, and then tells the whole turn at once.
TEST(IncrementalMatcher, IsNotTurnedTwiceByOdometryThatStandsStillAndCatchesUp) {
  TestRoom room = rectangular_room(5.0, 5.0);
  room.add_box({1.5, 0.4}, 0.3, 0.3);
  IncrementalMatcher matcher;
  double heading = 0.0, told = 0.0;
  for (int i = 0; i < 40; ++i) {
    const bool stalls = i >= 20 && i < 25;
    if (i >= 10 && i < 30) heading += 0.3;
    if (!stalls) told = heading;
    const double time = 0.2 * i;
    matcher.add(Odometry{.time = time, .odometry_from_robot = {0.0, 0.0, told}});
    matcher.add(scan_of(room, {0.0, 0.0, heading}, {}, time));
    EXPECT_THAT(matcher.pose(), IsNear(Pose2{0.0, 0.0, heading}, Tolerance{0.03, 0.02})) << i;
  }
}

TEST(IncrementalMatcher, MatchesAScanWithoutRememberingIt) {
  const RecordedLog log = round_trip(5);
  IncrementalMatcher plain, asked;
  for (const Measurement& measurement : log.measurements) {
    plain.add(measurement);
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) {
      EXPECT_EQ(asked.match(*scan).map_from_robot, plain.pose());  // where add() puts it
    }
    asked.add(measurement);
  }
  EXPECT_EQ(plain.pose(), asked.pose());
}

TEST(IncrementalMatcher, WorksWithoutOdometry) {
  const RecordedLog log = round_trip(6);
  IncrementalMatcherOptions options;
  options.use_odometry = false;
  EXPECT_LT(largest_error(log, run(log, options)), 0.5);
}

TEST(IncrementalMatcher, AlignsByIcpAndBySearchAsWell) {
  const RecordedLog log = round_trip(7);
  IncrementalMatcherOptions options;
  options.alignment = Alignment::icp;
  EXPECT_LT(largest_error(log, run(log, options)), 0.5);
  options.alignment = Alignment::correlative;
  EXPECT_LT(largest_error(log, run(log, options)), 0.5);
}

TEST(IncrementalMatcher, RecoversFromATurnThatOdometryMissed) {
  const TestRoom room = example_place();
  IncrementalMatcher matcher;
  const Pose2 start{7.0, 4.0, 0.0}, turned{7.0, 4.0, 1.3};
  matcher.add(Odometry{.time = 0.0});
  matcher.add(scan_of(room, start, {.beams = 360, .first_bearing = -kPi}, 0.0));
  matcher.add(Odometry{.time = 1.0});  // the wheels saw nothing
  matcher.add(scan_of(room, turned, {.beams = 360, .first_bearing = -kPi}, 1.0));
  EXPECT_THAT(matcher.pose(), IsNear(motion_between(start, turned), Tolerance{0.03, 0.02}));
}

// Here the climb ends on a side optimum: it explains enough to be trusted, too little to convince.
TEST(IncrementalMatcher, ChecksAWeakClimbByASearch) {
  const TestRoom room = example_place();
  const Pose2 start{5.0, 4.0, 0.0}, motion{-0.5, 0.0, 0.0};
  const auto matched = [&](double search_below) {
    IncrementalMatcher matcher({.search_below = search_below});
    matcher.add(Odometry{.time = 0.0});
    matcher.add(scan_of(room, start, {}, 0.0));
    matcher.add(Odometry{.time = 1.0});  // the wheels saw nothing
    matcher.add(scan_of(room, start * motion, {}, 1.0));
    return std::pair(distance(matcher.pose(), motion), matcher.last_match().trustworthy);
  };
  const auto [unchecked_error, unchecked_trust] = matched(0.0);
  EXPECT_GT(unchecked_error, 0.2);
  EXPECT_TRUE(unchecked_trust);
  EXPECT_LT(matched(IncrementalMatcherOptions{}.search_below).first, 0.06);
}

TEST(IncrementalMatcher, CountsScansOfALaserThatSeesNothingAndFollowsOdometry) {
  IncrementalMatcher matcher;
  for (int i = 0; i < 5; ++i) {
    matcher.add(Odometry{.time = 0.1 * i, .odometry_from_robot = {0.1 * i, 0.0, 0.0}});
    LaserScan blind{.time = 0.1 * i, .bearing_step = 0.1, .max_range = 8.0};
    blind.ranges.assign(30, 8.0);
    matcher.add(blind);
  }
  EXPECT_THAT(matcher.pose(), IsNear(Pose2{0.4, 0.0, 0.0}, Tolerance{1e-9, 1e-9}));
  EXPECT_EQ(matcher.estimate().untrusted_scans, 4);
}

// From one room into another one that was never seen; the scan there is remembered, though it fits
// nowhere.
class MatcherCarriedAway : public ::testing::Test {
 protected:
  MatcherCarriedAway() {
    add(example_place(), {7.0, 4.0, 0.0});
    add(example_place(), {7.6, 4.0, 0.0});
    add(elsewhere_, {-1.5, 0.0, 0.0});
  }
  void add(const TestRoom& room, const Pose2& pose) {
    matcher_.add(Odometry{.time = time_, .odometry_from_robot = {0.6 * time_, 0.0, 0.0}});
    matcher_.add(scan_of(room, pose, {.beams = 360, .first_bearing = -kPi}, time_));
    time_ += 1.0;
  }
  // 0.6 m on, but for 5 cm that the wheels missed.
  const ScanMatch& next_match_there() {
    add(elsewhere_, {-0.85, 0.0, 0.0});
    return matcher_.last_match();
  }

  const TestRoom elsewhere_ = rectangular_room(4.5, 2.6);
  IncrementalMatcher matcher_;
  double time_ = 0.0;  // [s]
};

TEST_F(MatcherCarriedAway, MatchesWithItsNewestScanAloneOnceThePastIsForgotten) {
  EXPECT_FALSE(matcher_.last_match().trustworthy);
  const Pose2 before = matcher_.pose();
  matcher_.forget_past(true);
  const ScanMatch& match = next_match_there();
  EXPECT_TRUE(match.trustworthy);
  EXPECT_THAT(match.map_from_robot, IsNear(before * Pose2{0.65, 0, 0}, Tolerance{0.025, 0.01}));
}

TEST_F(MatcherCarriedAway, FollowsOdometryOnceAllIsForgotten) {
  const Pose2 before = matcher_.pose();
  matcher_.forget_past(false);
  EXPECT_FALSE(next_match_there().trustworthy);
  EXPECT_THAT(matcher_.pose(), IsNear(before * Pose2{0.6, 0, 0}, Tolerance{1e-9, 1e-9}));
}

TEST(IncrementalMatcher, HasNothingToForgetAtFirst) {
  IncrementalMatcher matcher;
  matcher.forget_past(false);
  matcher.forget_past(true);
  EXPECT_EQ(matcher.pose(), Pose2{});
}

TEST(OdometryTrack, ReachesAStampBetweenAndAfterItsReadings) {
  OdometryTrack track;
  EXPECT_FALSE(track.at(0.0));
  track.add({.time = 1.0, .odometry_from_robot = {1.0, 0.0, 0.0}});
  track.add({.time = 2.0, .odometry_from_robot = {2.0, 0.0, 0.0}});
  EXPECT_THAT(*track.at(1.5), IsNear(Pose2{1.5, 0, 0}, Tolerance{1e-12, 1e-12}));
  EXPECT_THAT(*track.at(2.2), IsNear(Pose2{2.2, 0, 0}, Tolerance{1e-12, 1e-12}));
  EXPECT_FALSE(track.at(9.0));
}

// Of the posts in a corridor three stand where they did; two near ones were moved 0.4 m back, so
// that 0.4 m ahead as many beams find something where a post was. Odometry says that the robot
// stood.
TEST(IncrementalMatcher, StaysWhereOdometryHasItUnlessAnotherPlaceIsClearlyBetter) {
  const auto with_posts = [](const std::vector<double>& places) {
    TestRoom room = corridor(60.0);
    double side = 0.7;
    for (const double x : places) room.add_box({x, side = -side}, 0.2, 0.2);
    return room;
  };
  const TestLaser all_round{.beams = 360, .first_bearing = -kPi};
  IncrementalMatcherOptions options;
  options.search_below = 1.0;  // every climb is checked
  options.motion.odometry.position_per_time = options.motion.slip.position_per_time = 1.0;
  IncrementalMatcher matcher(options);
  matcher.add(Odometry{.time = 0.0});
  matcher.add(scan_of(with_posts({1.0, -1.7, 2.3, 3.9, -3.1}), {}, all_round, 0.0));
  matcher.add(Odometry{.time = 1.0});
  matcher.add(scan_of(with_posts({0.6, -1.7, 1.9, 3.9, -3.1}), {}, all_round, 1.0));
  EXPECT_THAT(matcher.pose(), IsNear(Pose2{}, Tolerance{0.05, 0.02}));
}

}  // namespace
}  // namespace mapbed
