#include "algorithms/lazy_association/lazy_slam.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// Twice round a corridor whose sides differ.
RecordedLog two_rounds(double scan_period = 0.5, double max_range = 6.0) {
  TestRoom room = ring_corridor(16.0);
  room.add_box({3.0, -6.3}, 0.4, 0.3);
  room.add_box({6.4, 2.0}, 0.3, 0.5);
  room.add_box({-1.0, 6.4}, 0.6, 0.3);
  room.add_box({-6.4, -1.0}, 0.3, 0.6);
  DriveOptions drive;
  drive.laser.max_range = max_range;
  drive.scan_period = scan_period;
  drive.drift_sigma = 0.05;
  return drive_through(room, {{-7, -7}, {7, -7}, {7, 7}, {-7, 7}, {-7, -7}, {7, -7}}, drive,
                       Rng(5));
}

Estimate run(const RecordedLog& log, const LazySlamOptions& options = {}) {
  LazySlam slam(options);
  for (const Measurement& measurement : log.measurements) slam.add(measurement);
  slam.finish();
  return slam.estimate();
}

// [m] of the motion from the first scan to one that sees the same corner, a round later.
double gap(const RecordedLog& log, const Trajectory& path) {
  const Stamped<Pose2>& last = path.back();
  const Pose2 truth = motion_between(*pose_at(log.true_poses, path.front().time),
                                     *pose_at(log.true_poses, last.time));
  return distance(truth, motion_between(path.front().pose, last.pose));
}

TEST(LazySlam, ClosesALoop) {
  const RecordedLog log = two_rounds();
  LazySlamOptions without_loops;
  without_loops.loops.search.candidates = 0;
  const double open = gap(log, run(log, without_loops).trajectory);
  EXPECT_GT(open, 0.15);
  EXPECT_LT(gap(log, run(log).trajectory), 0.5 * open);
}

TEST(LazySlam, TellsItsDecisions) {
  const Estimate estimate = run(two_rounds());
  ASSERT_TRUE(estimate.associations.has_value());
  const AssociationTree& tree = *estimate.associations;
  EXPECT_EQ(tree.choices.size() + 1, tree.local_maps.size());
  EXPECT_EQ(tree.nodes[tree.chosen].local_map, static_cast<int>(tree.local_maps.size()) - 1);
  const auto associated = std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                        [](const auto& node) { return node.associated >= 0; });
  EXPECT_GT(associated, 0);
  for (const AssociationTree::Node& node : tree.nodes) {
    EXPECT_LT(node.associated, node.local_map);
    EXPECT_LT(node.parent, static_cast<int>(tree.nodes.size()));
  }
  ASSERT_TRUE(estimate.graph.has_value());
  EXPECT_TRUE(std::any_of(estimate.graph->constraints.begin(), estimate.graph->constraints.end(),
                          [](const auto& constraint) { return constraint.closes_loop; }));
}

TEST(LazySlam, GivesTheSameBytesForAnyNumberOfThreads) {
  const RecordedLog log = two_rounds();
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return run(log).trajectory;
  };
  const Trajectory one = with_threads(1), four = with_threads(4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].pose, four[i].pose);
}

TEST(LazySlam, WorksWithoutOdometry) {
  RecordedLog log = two_rounds(0.1, 15.0);
  std::erase_if(log.measurements,
                [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
  EXPECT_LT(gap(log, run(log).trajectory), 0.3);
}

TEST(LazySlam, ALogWithNothingToAssociateHasOnlyNewPlaces) {
  const RecordedLog log =
      drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1));
  const Estimate estimate = run(log);
  EXPECT_LT(gap(log, estimate.trajectory), 0.03);
  LazySlam empty;
  empty.finish();
  EXPECT_TRUE(empty.estimate().trajectory.empty());
}

}  // namespace
}  // namespace mapbed
