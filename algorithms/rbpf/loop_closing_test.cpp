#include "algorithms/rbpf/loop_closing.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// Poses every metre from one corner to the next.
std::vector<Pose2> path_through(const std::vector<Pose2>& corners) {
  std::vector<Pose2> path{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double length = distance(corners[i - 1], corners[i]);
    for (double way = 1.0; way <= length; way += 1.0) {
      path.push_back(interpolate(corners[i - 1], corners[i], way / length));
    }
  }
  return path;
}

// The updates at which a loop is closed.
std::vector<std::size_t> closings(const std::vector<Pose2>& path, double inlier_ratio = 1.0) {
  LoopDetector detector({.distance = 1.5, .path_between = 15.0});
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::vector<Pose2> so_far(path.begin(),
                                    path.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    if (detector.closes(so_far, inlier_ratio)) result.push_back(i);
  }
  return result;
}

TEST(LoopDetector, FindsNoLoopOnAStraightWay) {
  EXPECT_TRUE(closings(path_through({{0, 0, 0}, {60, 0, 0}})).empty());
}

TEST(LoopDetector, SeesTheEntryOfTheKnownAreaOnce) {
  // Round a square of 10 m and on: 1 m before the start, after 39 m, the robot is back.
  const auto path =
      path_through({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 0}, {8, 0, 0}});
  EXPECT_EQ(closings(path), std::vector<std::size_t>{39});
}

TEST(LoopDetector, ClosesAgainAfterAnotherUnknownArea) {
  const auto path = path_through({{0, 0, 0},
                                  {10, 0, 0},
                                  {10, 10, 0},
                                  {0, 10, 0},
                                  {0, 0, 0},  // a loop
                                  {0, -10, 0},
                                  {10, -10, 0},
                                  {10, 0, 0}});  // another
  EXPECT_EQ(closings(path), (std::vector<std::size_t>{39, 69}));
}

TEST(LoopDetector, KnowsTheVeryFirstPose) {
  const std::vector<Pose2> square{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, 1, 0}};
  EXPECT_TRUE(is_back(square, {.distance = 1.5, .path_between = 15.0}));
}

TEST(LoopDetector, WaitsForAScanThatFits) {
  const auto path = path_through({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 0}});
  EXPECT_TRUE(closings(path, 0.3).empty());
}

TEST(LoopDetector, StandingOrTurningBackAtOnceIsNoLoop) {
  // There and back: 7 m out are 14 m of path, less than 15 m when back at the start.
  EXPECT_TRUE(closings(path_through({{0, 0, 0}, {7, 0, 0}, {0, 0, 0}})).empty());
}

}  // namespace
}  // namespace mapbed
