#include "algorithms/refinement/trajectory_refinement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

struct Walk {
  std::vector<Pose2> truth;
  std::vector<ScanForWeighting> scans;
  std::vector<PathStep> steps;  // with true motions and poses that are off, the first one apart
};

// To and fro in a room.
Walk walk_with_errors(double sigma, double sigma_turn) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  Walk walk;
  for (int i = 0; i < 12; ++i) walk.truth.push_back({-1.5 + 0.3 * i, 0.2 * (i % 3), 0.5 * i});
  for (const Pose2& pose : walk.truth) {
    walk.scans.push_back(scan_for_weighting(scan_of(room, pose), {}, {}, 0.1));
  }
  Rng rng(2);
  for (std::size_t i = 0; i < walk.truth.size(); ++i) {
    const Pose2 error{rng.normal(0, sigma), rng.normal(0, sigma), rng.normal(0, sigma_turn)};
    const Pose2 motion = i == 0 ? Pose2{} : motion_between(walk.truth[i - 1], walk.truth[i]);
    walk.steps.push_back({i == 0 ? walk.truth[0] : walk.truth[i] * error, motion, &walk.scans[i]});
  }
  return walk;
}

// Of the motions between all poses: the whole path may lie anywhere.
double mean_error(const std::vector<Pose2>& truth, const std::vector<Pose2>& path) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++count) {
      sum += distance(motion_between(truth[j], truth[i]), motion_between(path[j], path[i]));
    }
  }
  return sum / count;
}

std::vector<Pose2> poses_of(const std::vector<PathStep>& steps) {
  std::vector<Pose2> poses;
  for (const PathStep& step : steps) poses.push_back(step.pose);
  return poses;
}

TEST(TrajectoryRefinement, TakesOutWhatDrawingAdded) {
  const Walk walk = walk_with_errors(0.02, 0.01);
  const double before = mean_error(walk.truth, poses_of(walk.steps));
  const double after = mean_error(walk.truth, refined(walk.steps, {}, {}).poses);
  EXPECT_GT(before, 0.02);
  EXPECT_LT(after, 0.25 * before);
}

TEST(TrajectoryRefinement, LeavesAPathThatFitsWhereItIs) {
  const Walk walk = walk_with_errors(0.0, 0.0);
  const std::vector<Pose2> path = refined(walk.steps, {}, {}).poses;
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_THAT(path[i], IsNear(walk.truth[i], Tolerance{0.005, 0.003}));
  }
}

TEST(TrajectoryRefinement, WithoutRoundsIsThePathAsItWasDrawn) {
  const Walk walk = walk_with_errors(0.02, 0.01);
  EXPECT_EQ(refined(walk.steps, {}, {.rounds = 0}).poses, poses_of(walk.steps));
}

TEST(TrajectoryRefinement, OfOnePoseLeavesIt) {
  const ScanForWeighting nothing;
  const std::vector<PathStep> path{{{1.0, 2.0, 0.3}, {}, &nothing}};
  EXPECT_EQ(refined(path, {}, {}).poses, poses_of(path));
}

TEST(TrajectoryRefinement, ScansBetweenAnchorsAreMatchedWithTheMapOfThePath) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const auto seen_at = [&](const Pose2& pose) {
    return scan_for_weighting(scan_of(room, pose), {}, {}, 0.1);
  };
  const Pose2 start{-0.5, 0.2, 0.1}, truth{-0.2, 0.3, 0.15};
  KeptHits hits;
  for (const Eigen::Vector2d& hit : seen_at(truth).hits) hits.push_back(hit.cast<float>());
  // The motion that was seen is 6 cm too long; motions are held to be right to 5 cm, the scan to
  // 1 or 2: it leaves a tenth of the error at most.
  const Pose2 seen = motion_between(start, truth) * Pose2{0.06, 0.0, 0.0};
  const Track track{.scans = {{.anchors = 1, .is_anchor = true},
                              {.time = 1.0, .track_from_robot = seen, .anchors = 1}},
                    .track_from_anchors = {{}}};
  const RefinedPath path = refined({start}, {seen_at(start)}, track, {});
  const Trajectory trajectory = refined_trajectory(path, track, {{}, hits}, {});
  EXPECT_THAT(trajectory[1].pose, IsNear(truth, Tolerance{0.015, 0.015}));
}

}  // namespace
}  // namespace mapbed
