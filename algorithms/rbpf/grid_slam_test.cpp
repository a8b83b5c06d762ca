#include "algorithms/rbpf/grid_slam.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/rbpf/testing/drives.h"

namespace mapbed {
namespace {

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
  const std::vector<Diversity> diversity = filter_after(log, options).hypotheses().diversity;
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
  EXPECT_TRUE(collapses(filter_after(log, options).hypotheses().diversity).empty());
  options.best_only_after_loop = true;
  const std::vector<Diversity> diversity = filter_after(log, options).hypotheses().diversity;
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
  const Hypotheses hypotheses = filter_after(log, options).hypotheses();
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
  Trajectory odometry;
  for (const Measurement& measurement : log.measurements) {
    if (const auto* reading = std::get_if<Odometry>(&measurement)) {
      odometry.push_back({reading->time, reading->odometry_from_robot});
    }
  }
  const std::vector<GridSlam::Motion> motions = filter_after(log, options).motions();
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

TEST(GridSlam, BeforeTheFirstScanBelievesNothing) {
  GridSlam slam({}, Rng(1));
  slam.add(Odometry{.time = 0.0});
  EXPECT_TRUE(slam.estimate().trajectory.empty());
  EXPECT_EQ(slam.pose(), Pose2{});
}

// The last scan sees nothing, which changes no weight: those are what resampling left.
TEST(GridSlam, ParticlesWeighTheSameAfterResampling) {
  GridSlamOptions options;
  options.particles = 10;
  options.proposal = Proposal::odometry;
  options.resampling = Resampling::always;
  GridSlam slam(options, Rng(1));
  for (int i = 0; i < 4; ++i) {
    slam.add(Odometry{.time = 1.0 * i, .odometry_from_robot = {0.6 * i, 0.0, 0.0}});
    LaserScan scan = scan_of(rectangular_room(6.0, 4.0), {0.6 * i - 1.0, 0.0, 0.0}, {}, 1.0 * i);
    if (i == 3) std::fill(scan.ranges.begin(), scan.ranges.end(), 0.0);
    slam.add(scan);
  }
  const std::vector<Diversity> updates = slam.hypotheses().diversity;
  ASSERT_EQ(updates.size(), 4U);
  EXPECT_LT(updates[2].effective_number, 9.9);  // until they are drawn anew, they differ
  EXPECT_NEAR(updates[3].effective_number, 10.0, 1e-9);
}

}  // namespace
}  // namespace mapbed
