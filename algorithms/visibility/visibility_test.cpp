// The three rules of visibility, each on a row of cells that beams look along, and on a drive.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/visibility/ever_free.h"
#include "algorithms/visibility/saturated_map.h"
#include "algorithms/visibility/visibility_vote.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// Parallel beams from the middle of the first cells of three rows of 1 m; those of the outer rows
// pass.
LaserScan rows(double time, const std::vector<double>& ranges_of_middle) {
  LaserScan scan;
  scan.time = time;
  scan.max_range = 20.0;
  scan.ranges = ranges_of_middle;
  scan.robot_from_beams.assign(ranges_of_middle.size(), Pose2{});
  for (const double side : {-1.0, 1.0}) {
    scan.ranges.push_back(7.0);
    scan.robot_from_beams.push_back({0.0, side, 0.0});
  }
  return scan;
}

// 'h' ends in the fourth cell of the middle row, 'p' passes it.
std::vector<LaserScan> looks(const std::string& looks) {
  std::vector<LaserScan> scans;
  for (const char look : looks) {
    scans.push_back(rows(static_cast<double>(scans.size()), {look == 'h' ? 3.0 : 7.0}));
  }
  return scans;
}

// So many hits, then so many passes.
std::string hits_then_passes(std::size_t hits, std::size_t passes) {
  std::string text(hits, 'h');
  text.append(passes, 'p');
  return text;
}

// Whether the first beam that ended in the fourth cell is dynamic.
template <class Filter>
bool is_taken_for_dynamic(Filter filter, const std::vector<LaserScan>& scans) {
  Trajectory path;
  for (const LaserScan& scan : scans) {
    EXPECT_TRUE(filter.add(scan, {}).empty());
    path.push_back({scan.time, {0.5, 0.5, 0.0}});
  }
  const BeamLabels labels = filter.result(path).labels;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (std::size_t n = 0; n < scans[i].ranges.size(); ++n) {
      if (scans[i].ranges[n] == 3.0) return is_dynamic(labels[i], n);
    }
  }
  ADD_FAILURE() << "nothing ended there";
  return false;
}

bool by_vote(const std::vector<LaserScan>& scans) {
  return is_taken_for_dynamic(VisibilityVote({.ratio = 3.0, .resolution = 1.0, .end_margin = 0.0}),
                              scans);
}

TEST(VisibilityVote, WantsMoreScansThatSawThroughThanTheRatio) {
  EXPECT_FALSE(by_vote(looks("hppp")));
  EXPECT_TRUE(by_vote(looks("hpppp")));
  EXPECT_TRUE(by_vote(looks("pphpp"))) << "whenever";
}

TEST(VisibilityVote, EachScanVotesOnceAndForWhatItSaw) {
  std::vector<LaserScan> scans = looks("hpp");
  scans[1] = rows(1.0, {7.0, 7.0, 7.0, 7.0});
  EXPECT_FALSE(by_vote(scans));
  scans[0] = rows(0.0, {7.0, 3.0});
  EXPECT_FALSE(by_vote(scans)) << "a hit outweighs the pass of its own scan";
}

bool by_saturated_map(const std::vector<LaserScan>& scans) {
  return is_taken_for_dynamic(SaturatedMap({.resolution = 1.0, .end_margin = 0.0}), scans);
}

TEST(SaturatedMap, BelievesWhatItSawLast) {
  EXPECT_FALSE(by_saturated_map(looks("pppppppppphhhhhhhh")));
  EXPECT_TRUE(by_saturated_map(looks("hhhhhhhhhhpppppppppp")));
}

TEST(SaturatedMap, ForgetsSoonBecauseItIsNeverTooSure) {
  // From 0.971, log odds 3.5, nine passes of -0.405 lead below 0; a hundred hits before are the
  // same.
  EXPECT_TRUE(by_saturated_map(looks(hits_then_passes(5, 9))));
  EXPECT_TRUE(by_saturated_map(looks(hits_then_passes(100, 9))));
  EXPECT_FALSE(by_saturated_map(looks(hits_then_passes(100, 8))));
}

bool by_ever_free(const std::vector<LaserScan>& scans) {
  return is_taken_for_dynamic(
      EverFree({.scans = 3, .sensor_margin = 0.0, .pose_margin = 0.0, .resolution = 1.0}), scans);
}

TEST(EverFree, WhatWasSurelyFreeAFewTimesIsNeverOfThePlace) {
  EXPECT_TRUE(by_ever_free(looks(hits_then_passes(100, 3))));
  EXPECT_FALSE(by_ever_free(looks(hits_then_passes(100, 2))));
}

LaserScan fan(std::vector<double> ranges) {
  LaserScan scan;
  scan.max_range = 20.0;
  scan.first_bearing = -0.02 * static_cast<double>(ranges.size() / 2);
  scan.bearing_step = 0.02;
  scan.ranges = std::move(ranges);
  return scan;
}

TEST(ClearedLength, EndsBeforeTheHit) {
  EXPECT_NEAR(cleared_lengths(fan({5.0}), {}, 0.1, 0.2)[0], 5.0 - 0.1 - 0.2, 1e-12);
  EXPECT_EQ(cleared_lengths(fan({0.0}), {}, 0.1, 0.2)[0], 0.0) << "it says nothing";
}

// The neighbour's hit at 3 m lies 3 sin 0.02 = 6 cm beside.
TEST(ClearedLength, EndsWhereSomethingIsNearBesideTheBeam) {
  const std::vector<double> cleared = cleared_lengths(fan({3.0, 9.0}), {}, 0.1, 0.1);
  const double beside = 3.0 * std::sin(0.02);
  EXPECT_NEAR(cleared[1], 3.0 * std::cos(0.02) - 0.1 - std::sqrt(0.01 - beside * beside), 1e-12);
  EXPECT_NEAR(cleared_lengths(fan({3.0, 9.0}), {}, 0.1, 0.05)[1], 9.0 - 0.15, 1e-12)
      << "farther beside than the margin";
}

// A room with a box that goes after a sixth of the drive; poses are off by a centimetre.
class ARoom : public ::testing::Test {
 protected:
  ARoom() {
    const std::vector<Eigen::Vector2d> way{{-2.0, 0.0}, {2.0, 0.3}, {-2.0, 0.2}};
    TestRoom room = rectangular_room(7.0, 5.0);
    const RecordedLog empty = drive_through(room, way, {}, Rng(1));
    room.add_box({0.5, -1.2}, 0.4, 0.4);
    const RecordedLog full = drive_through(room, way, {}, Rng(1));
    Rng rng(2);
    for (std::size_t i = 0; i < empty.measurements.size(); ++i) {
      const auto* without = std::get_if<LaserScan>(&empty.measurements[i]);
      if (without == nullptr) continue;
      const auto& with = std::get<LaserScan>(full.measurements[i]);
      const bool is_there = i < empty.measurements.size() / 6;
      scans_.push_back(is_there ? with : *without);
      std::vector<bool>& on_box = on_box_.emplace_back();
      for (std::size_t n = 0; n < with.ranges.size(); ++n) {
        on_box.push_back(is_there && with.ranges[n] < without->ranges[n] - 0.3);
      }
      Pose2 pose = empty.true_poses[scans_.size() - 1].pose;
      pose.x += rng.normal(0.0, 0.01);
      pose.y += rng.normal(0.0, 0.01);
      path_.push_back({scans_.back().time, pose});
    }
  }

  template <class Filter>
  void expect_found(Filter filter) {
    for (const LaserScan& scan : scans_) filter.add(scan, {});
    const BeamLabels labels = filter.result(path_).labels;
    long of_box = 0, found = 0, of_room = 0, lost = 0;
    for (std::size_t i = 0; i < scans_.size(); ++i) {
      for (std::size_t n = 0; n < scans_[i].ranges.size(); ++n) {
        ++(on_box_[i][n] ? of_box : of_room);
        if (is_dynamic(labels[i], n)) ++(on_box_[i][n] ? found : lost);
      }
    }
    ASSERT_GT(of_box, 100);
    EXPECT_GT(static_cast<double>(found), 0.8 * static_cast<double>(of_box));
    EXPECT_LT(static_cast<double>(lost), 0.03 * static_cast<double>(of_room));
  }

  std::vector<LaserScan> scans_;
  std::vector<std::vector<bool>> on_box_;
  Trajectory path_;
};

TEST_F(ARoom, VotesFindABoxThatGoesAndLeaveTheWalls) {
  expect_found(VisibilityVote({.ratio = 1.0}));
}

TEST_F(ARoom, ASaturatedMapFindsABoxThatGoesAndLeavesTheWalls) {
  expect_found(SaturatedMap());
}

TEST_F(ARoom, FreeSpaceFindsABoxThatGoesAndLeavesTheWalls) {
  expect_found(EverFree());
}

}  // namespace
}  // namespace mapbed
