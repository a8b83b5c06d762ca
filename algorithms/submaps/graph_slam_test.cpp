#include "algorithms/submaps/graph_slam.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// Twice round a corridor whose four sides differ.
RecordedLog two_rounds(const DriveOptions& drive) {
  TestRoom room = ring_corridor(24.0);
  room.add_box({3.0, -10.3}, 0.4, 0.3);
  room.add_box({-6.0, -11.7}, 0.5, 0.4);
  room.add_box({10.4, 2.0}, 0.3, 0.5);
  room.add_box({11.7, -5.0}, 0.3, 1.0);
  room.add_box({-1.0, 10.4}, 0.6, 0.3);
  room.add_box({6.0, 11.7}, 1.2, 0.3);
  room.add_box({-10.4, -1.0}, 0.3, 0.6);
  room.add_box({-11.7, 6.0}, 0.3, 0.4);
  return drive_through(room,
                       {{-11, -11}, {11, -11}, {11, 11}, {-11, 11}, {-11, -11}, {11, -11}, {11, 0}},
                       drive, Rng(4));
}

DriveOptions poor_odometry() {
  DriveOptions drive;
  drive.laser.max_range = 6.0;
  drive.scan_period = 0.5;
  drive.drift_sigma = 0.05;
  return drive;
}

Estimate run(const RecordedLog& log, const GraphSlamOptions& options = {}) {
  GraphSlam slam(options);
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  slam.finish();
  return slam.estimate();
}

double largest_error(const RecordedLog& log, const Trajectory& path) {
  const Pose2 first = *pose_at(log.true_poses, path.front().time);
  double largest = 0.0;
  for (const Stamped<Pose2>& stamped : path) {
    const Pose2 truth = motion_between(first, *pose_at(log.true_poses, stamped.time));
    largest = std::max(largest, distance(truth, motion_between(path.front().pose, stamped.pose)));
  }
  return largest;
}

// Where the robot passes a place again, 88 m later: by how much the two passes lie wrong to each
// other [m].
double largest_gap(const RecordedLog& log, const Trajectory& path) {
  double largest = 0.0;
  for (const Stamped<Pose2>& later : path) {
    for (const Stamped<Pose2>& earlier : path) {
      if (later.time - earlier.time < 100.0) continue;
      const Pose2 truth = motion_between(*pose_at(log.true_poses, earlier.time),
                                         *pose_at(log.true_poses, later.time));
      if (truth.position().norm() > 1.0) continue;
      largest = std::max(largest, distance(truth, motion_between(earlier.pose, later.pose)));
    }
  }
  return largest;
}

TEST(GraphSlam, ClosesALoopThatScanMatchingLeavesOpen) {
  const RecordedLog log = two_rounds(poor_odometry());
  GraphSlamOptions without_loops;
  without_loops.loops.search.candidates = 0;
  const double open = largest_gap(log, run(log, without_loops).trajectory);
  const double closed = largest_gap(log, run(log).trajectory);
  EXPECT_GT(open, 0.2);
  EXPECT_LT(closed, 0.5 * open);
}

TEST(GraphSlam, GivesTheSameBytesForAnyNumberOfThreads) {
  const RecordedLog log = two_rounds(poor_odometry());
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return run(log).trajectory;
  };
  const Trajectory one = with_threads(1), four = with_threads(4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].pose, four[i].pose);
}

TEST(GraphSlam, HasAPoseForEachScanAndSaysWhatItClosed) {
  const RecordedLog log = two_rounds(poor_odometry());
  const auto scans =
      std::count_if(log.measurements.begin(), log.measurements.end(),
                    [](const Measurement& m) { return std::holds_alternative<LaserScan>(m); });
  const Estimate estimate = run(log);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(estimate.trajectory.size()), scans);
  ASSERT_FALSE(estimate.remarks.empty());
  EXPECT_THAT(estimate.remarks.back().text, ::testing::HasSubstr("constraints that close loops"));
}

TEST(GraphSlam, ALogWithNothingToAssociateIsScanMatching) {
  const RecordedLog log =
      drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
  EXPECT_LT(largest_error(log, run(log).trajectory), 0.03);
  EXPECT_TRUE(GraphSlam().estimate().trajectory.empty());
  GraphSlam empty;
  empty.finish();
  EXPECT_TRUE(empty.estimate().trajectory.empty());
}

}  // namespace
}  // namespace mapbed
