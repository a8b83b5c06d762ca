#include "algorithms/rbpf/grid_slam.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

RecordedLog two_rounds(double drift_sigma = 0.02) {
  DriveOptions drive;
  drive.drift_sigma = drift_sigma;
  drive.laser.max_range = 15.0;
  TestRoom room = ring_corridor();
  room.add_box({3.0, -4.3}, 0.4, 0.3);
  room.add_box({4.4, 2.0}, 0.3, 0.5);
  room.add_box({-1.0, 4.4}, 0.6, 0.3);
  room.add_box({-4.4, -1.0}, 0.3, 0.6);
  return drive_through(room, {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {-5, -5}, {5, -5}}, drive,
                       Rng(4));
}

Estimate run(const RecordedLog& log, const GridSlamOptions& options, std::uint64_t seed = 1) {
  GridSlam slam(options, Rng(seed));
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  return slam.estimate();
}

double error_at_end(const RecordedLog& log, const Estimate& estimate) {
  const Pose2 first = *pose_at(log.true_poses, estimate.trajectory.front().time);
  const Pose2 last = *pose_at(log.true_poses, estimate.trajectory.back().time);
  return distance(motion_between(first, last), estimate.trajectory.back().pose);
}

class ClosesALoop : public ::testing::TestWithParam<Proposal> {};

TEST_P(ClosesALoop, WithFewParticles) {
  const RecordedLog log = two_rounds();
  GridSlamOptions options;
  options.particles = 30;
  options.proposal = GetParam();
  // Where the scan only weights and does not say where to draw, its beams count for more.
  if (GetParam() == Proposal::scan_matching) options.likelihood.beam_weight = 0.5;
  EXPECT_LT(error_at_end(log, run(log, options)), 0.5);
}

INSTANTIATE_TEST_SUITE_P(GridSlam, ClosesALoop,
                         ::testing::Values(Proposal::scan_matching, Proposal::improved));

TEST(GridSlam, GivesTheSameBytesForAnyNumberOfThreads) {
  const RecordedLog log = two_rounds();
  GridSlamOptions options;
  options.particles = 8;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return run(log, options).trajectory;
  };
  const Trajectory one = with_threads(1), two = with_threads(2), eight = with_threads(8);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pose, two[i].pose);
    EXPECT_EQ(one[i].pose, eight[i].pose);
  }
}

TEST(GridSlam, ParticlesShareTheirPast) {
  const RecordedLog log = two_rounds();
  GridSlamOptions options;
  options.particles = 20;
  options.resampling = Resampling::always;
  GridSlam slam(options, Rng(1));
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  const std::vector<Diversity> diversity = slam.hypotheses().diversity;
  EXPECT_EQ(diversity.front().distinct_ancestors, 1);  // all start at one pose
  EXPECT_EQ(diversity.back().distinct_ancestors, 20);
  for (std::size_t i = 1; i < diversity.size(); ++i) {
    EXPECT_GE(diversity[i].distinct_ancestors, diversity[i - 1].distinct_ancestors);
  }
}

// The updates at which one particle alone survived.
std::vector<std::size_t> collapses(const std::vector<Diversity>& diversity) {
  std::vector<std::size_t> result;
  for (std::size_t i = 1; i < diversity.size(); ++i) {
    if (diversity[i].effective_number == 1.0) result.push_back(i);
  }
  return result;
}

TEST(GridSlam, GoesOnWithTheBestParticleAloneOnceALoopIsClosed) {
  const RecordedLog log = two_rounds();
  GridSlamOptions options;
  options.particles = 20;
  options.resampling = Resampling::never;
  GridSlam all(options, Rng(1));
  options.best_only_after_loop = true;
  GridSlam best_only(options, Rng(1));
  for (const Measurement& measurement : log.measurements) {
    all.add(measurement);
    best_only.add(measurement);
  }
  EXPECT_TRUE(collapses(all.hypotheses().diversity).empty());
  const std::vector<Diversity> diversity = best_only.hypotheses().diversity;
  const std::vector<std::size_t> at = collapses(diversity);
  ASSERT_EQ(at.size(), 1U);  // the second round leads through known areas only
  EXPECT_EQ(diversity[at.front() - 1].distinct_ancestors, 1);
  EXPECT_EQ(diversity[at.front()].distinct_ancestors, 20);
  // A round is 40 m long; the robot is back 2 m before its end.
  const Pose2 there = *pose_at(log.true_poses, diversity[at.front()].time);
  const Pose2 start = log.true_poses.front().pose;
  EXPECT_NEAR(distance(there, start), options.loop_closing.distance, options.update_distance);
}

TEST(GridSlam, HypothesesHoldEachPoseOfTheParticlesPathsOnce) {
  const RecordedLog log = two_rounds();
  GridSlamOptions options;
  options.particles = 10;
  options.resampling = Resampling::always;
  GridSlam slam(options, Rng(1));
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  const Hypotheses hypotheses = slam.hypotheses();
  ASSERT_FALSE(hypotheses.branches.empty());
  EXPECT_EQ(hypotheses.branches.front().size(), hypotheses.diversity.size());  // a whole path
  std::size_t poses = hypotheses.branches.front().size();
  for (std::size_t i = 1; i < hypotheses.branches.size(); ++i) {
    poses += hypotheses.branches[i].size() - 1;  // without the one where it parted
  }
  std::size_t ancestors = 0;
  for (const Diversity& update : hypotheses.diversity) {
    ancestors += static_cast<std::size_t>(update.distinct_ancestors);
  }
  EXPECT_EQ(poses, ancestors);
}

TEST(GridSlam, CondensedMotionsAreBetterThanOdometry) {
  const RecordedLog log = two_rounds();
  GridSlamOptions options;
  options.particles = 1;
  options.proposal = Proposal::scan_matching;
  GridSlam slam(options, Rng(1));
  Trajectory odometry;
  for (const Measurement& measurement : log.measurements) {
    slam.add(measurement);
    if (const auto* reading = std::get_if<Odometry>(&measurement)) {
      odometry.push_back({reading->time, reading->odometry_from_robot});
    }
  }
  const std::vector<GridSlam::Motion> motions = slam.motions();
  ASSERT_GT(motions.size(), 40U);
  const auto between = [](const Trajectory& path, const GridSlam::Motion& step) {
    return motion_between(*pose_at(path, step.from_time), *pose_at(path, step.to_time));
  };
  double turned_by_odometry = 0.0, turned_by_matching = 0.0;  // [rad] off
  for (const GridSlam::Motion& step : motions) {
    const double turn = between(log.true_poses, step).theta;
    turned_by_odometry += std::abs(angle_difference(turn, between(odometry, step).theta));
    turned_by_matching += std::abs(angle_difference(turn, step.motion.theta));
  }
  EXPECT_LT(turned_by_matching, turned_by_odometry);
}

TEST(GridSlam, StaysFiniteWhenTheLaserSeesNothingAndSaysSo) {
  GridSlamOptions options;
  options.particles = 5;
  GridSlam slam(options, Rng(1));
  for (int i = 0; i < 20; ++i) {
    slam.add(Odometry{.time = 1.0 * i, .odometry_from_robot = {0.6 * i, 0.0, 0.0}});
    LaserScan blind{.time = 1.0 * i, .bearing_step = 0.02, .max_range = 8.0};
    blind.ranges.assign(100, 8.0);
    slam.add(blind);
  }
  const Estimate estimate = slam.estimate();
  for (const StampedPose& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  EXPECT_NEAR(estimate.trajectory.back().pose.x, 0.6 * 19, 2.0);  // where odometry has it
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("the laser sees nothing from 0.0 s to 19.0 s")));
}

TEST(GridSlam, WorksWithoutOdometryAndSaysSo) {
  RecordedLog log = two_rounds();
  std::erase_if(log.measurements,
                [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("no odometry from")));
}

// As where the robot's counters were set back on the way.
TEST(GridSlam, OutlivesAJumpOfOdometryAndSaysSo) {
  RecordedLog log = two_rounds();
  const double half = 0.5 * (log.true_poses.front().time + log.true_poses.back().time);
  for (Measurement& measurement : log.measurements) {
    auto* odometry = std::get_if<Odometry>(&measurement);
    if (odometry == nullptr || odometry->time < half) continue;
    odometry->odometry_from_robot = Pose2{5.0, -3.0, 1.0} * odometry->odometry_from_robot;
  }
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("odometry jumps from")));
}

TEST(GridSlam, OutlivesTenSecondsWithoutScansAndSaysSo) {
  RecordedLog log = two_rounds();
  const double half = 0.5 * (log.true_poses.front().time + log.true_poses.back().time);
  std::erase_if(log.measurements, [&](const Measurement& m) {
    return std::holds_alternative<LaserScan>(m) && time_of(m) > half && time_of(m) < half + 10.0;
  });
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("no scan from")));
}

// A room that looks different in all directions.
TestRoom furnished_room() {
  TestRoom room = rectangular_room(12.0, 9.0);
  room.add_box({-4.0, 3.2}, 1.5, 0.8);
  room.add_box({4.8, -2.0}, 0.8, 2.0);
  room.add_box({1.5, 3.8}, 0.6, 0.6);
  room.add_box({-5.2, -2.5}, 0.7, 1.2);
  room.add_box({0.5, -4.0}, 2.2, 0.5, 0.3);
  return room;
}

// One scan every two seconds, and odometry misses the turn of 90 degrees at the first corner. The
// wheels tell of a step straight on, which they believe to a few degrees.
TEST(GridSlam, BelievesTheScansWhereTheyRefuteOdometry) {
  DriveOptions drive;
  drive.laser = {.beams = 361, .first_bearing = -kPi, .max_range = 15.0};
  RecordedLog log = drive_through(furnished_room(), {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}, {-3, -1}},
                                  drive, Rng(4));
  const double start = log.true_poses.front().time;
  Pose2 last, told;
  for (Measurement& measurement : log.measurements) {
    auto* odometry = std::get_if<Odometry>(&measurement);
    if (odometry == nullptr) continue;
    Pose2 step = motion_between(last, odometry->odometry_from_robot);
    last = odometry->odometry_from_robot;
    // 12 s to the first corner, 2 s there.
    const double time = odometry->time - start;
    if (time > 11.0 && time < 15.0) step.theta = 0.0;
    told = told * step;
    odometry->odometry_from_robot = told;
  }
  int number = 0;
  std::erase_if(log.measurements, [&](const Measurement& m) {
    return std::holds_alternative<LaserScan>(m) && number++ % 8 != 0;
  });
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.1);
}

// Carried into another place while the wheels stand still: nothing of it is on the map.
TEST(GridSlam, SaysThatItIsLostWhereTheMapExplainsNothing) {
  RecordedLog log = two_rounds();
  DriveOptions drive;
  drive.laser.max_range = 15.0;
  drive.start_time = log.true_poses.back().time + 1.0;
  TestRoom elsewhere({});
  Rng rng(3);
  for (int i = 0; i < 150; ++i) {
    elsewhere.add_box({rng.uniform(-12, 12), rng.uniform(-12, 12)}, rng.uniform(0.2, 0.5),
                      rng.uniform(0.2, 0.5), rng.uniform(0, 3));
  }
  const RecordedLog after = drive_through(elsewhere, {{-9.9, 0}, {9.9, 0.1}}, drive, Rng(4));
  GridSlamOptions options;
  options.particles = 20;
  GridSlam slam(options, Rng(1));
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  for (const std::string& remark : slam.estimate().remarks)
    EXPECT_THAT(remark, Not(HasSubstr("lost")));
  for (const Measurement& measurement : after.measurements) slam.add(measurement);
  const Estimate estimate = slam.estimate();
  for (const StampedPose& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("lost from")));
}

// Carried 5 m across a known room without its wheels turning, then driving on there.
struct CarriedAway {
  RecordedLog log;
  double time = 0.0;  // [s]
};
CarriedAway carried_away(const TestRoom& there, const std::vector<Eigen::Vector2d>& way_there,
                         const Pose2& jump = {}) {
  DriveOptions drive;
  drive.laser = {.beams = 361, .first_bearing = -kPi, .max_range = 15.0};
  CarriedAway result{
      .log = drive_through(furnished_room(), {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}}, drive, Rng(4))};
  const Pose2 odometry_at_end =
      std::get<Odometry>(result.log.measurements.end()[-2]).odometry_from_robot;
  result.time = drive.start_time = result.log.true_poses.back().time + drive.scan_period;
  RecordedLog after = drive_through(there, way_there, drive, Rng(5));
  for (Measurement& measurement : after.measurements) {
    if (auto* odometry = std::get_if<Odometry>(&measurement)) {
      odometry->odometry_from_robot = odometry_at_end * jump * odometry->odometry_from_robot;
    }
    result.log.measurements.push_back(measurement);
  }
  result.log.true_poses.insert(result.log.true_poses.end(), after.true_poses.begin(),
                               after.true_poses.end());
  return result;
}

class FindsItselfAgain : public ::testing::TestWithParam<Pose2> {};

TEST_P(FindsItselfAgain, AfterItWasCarriedAcrossTheMap) {
  const CarriedAway carried = carried_away(furnished_room(), {{1, -2}, {-3, -1}}, GetParam());
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(carried.log, options);
  EXPECT_LT(error_at_end(carried.log, estimate), 0.1);
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("found again at")));
  EXPECT_THAT(estimate.remarks, Not(Contains(HasSubstr("is not known"))));
  // So is the whole path, but for the half metre after it, of which nobody can say on which side of
  // the carrying it lies: the next update is made then.
  const Pose2 first = carried.log.true_poses.front().pose;
  for (const StampedPose& stamped : estimate.trajectory) {
    if (stamped.time >= carried.time && stamped.time < carried.time + 1.0) continue;
    const Pose2 truth = motion_between(first, *pose_at(carried.log.true_poses, stamped.time));
    EXPECT_LT(distance(stamped.pose, truth), 0.2) << stamped.time;
  }
}

// The odometry's counters stand still, or jump as well.
INSTANTIATE_TEST_SUITE_P(GridSlam, FindsItselfAgain,
                         ::testing::Values(Pose2{}, Pose2{7.0, -3.0, 1.0}));

// Four sides that look alike: the robot may be in any of them, and stays where it was.
TEST(GridSlam, DoesNotLeaveItsPlaceForOneThatLooksTheSame) {
  DriveOptions drive;
  drive.laser.max_range = 15.0;
  RecordedLog log =
      drive_through(ring_corridor(), {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}, {-5, -5}}, drive, Rng(4));
  const double late = log.true_poses.front().time + 60.0;  // on the third side
  for (Measurement& measurement : log.measurements) {
    auto* odometry = std::get_if<Odometry>(&measurement);
    if (odometry == nullptr || odometry->time < late) continue;
    odometry->odometry_from_robot = Pose2{5.0, -3.0, 1.0} * odometry->odometry_from_robot;
  }
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(log, options);
  EXPECT_LT(error_at_end(log, estimate), 0.5);
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("odometry jumps")));
  EXPECT_THAT(estimate.remarks, Not(Contains(HasSubstr("lost"))));
}

TEST(GridSlam, IsLostWhereItWasCarriedIntoTheUnknown) {
  TestRoom elsewhere = rectangular_room(5.0, 14.0);
  elsewhere.add_box({1.0, 3.0}, 0.6, 0.9, 0.4);
  elsewhere.add_box({-1.4, -4.0}, 1.6, 0.4, 0.8);
  const CarriedAway carried = carried_away(elsewhere, {{0, -5}, {0, 5}}, {7.0, -3.0, 1.0});
  GridSlamOptions options;
  options.particles = 20;
  const Estimate estimate = run(carried.log, options);
  for (const StampedPose& stamped : estimate.trajectory) EXPECT_TRUE(is_finite(stamped.pose));
  EXPECT_THAT(estimate.remarks, Not(Contains(HasSubstr("found again"))));
  EXPECT_THAT(estimate.remarks, Contains(HasSubstr("lost from")));
}

TEST(GridSlam, BeforeTheFirstScanBelievesNothing) {
  GridSlam slam({}, Rng(1));
  slam.add(Odometry{.time = 0.0});
  EXPECT_TRUE(slam.estimate().trajectory.empty());
  EXPECT_EQ(slam.pose(), Pose2{});
}

}  // namespace
}  // namespace mapbed
