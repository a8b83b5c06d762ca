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

// In cells of 1 m, of which those beside the row may be unknown.
bool by_ever_free(const std::vector<LaserScan>& scans) {
  return is_taken_for_dynamic(
      EverFree({.scans = 3, .sensor_margin = 0.0, .pose_margin = 0, .resolution = 1.0}), scans);
}

TEST(EverFree, WhatWasSurelyFreeOnceIsNeverOfThePlace) {
  EXPECT_TRUE(by_ever_free(looks(hits_then_passes(100, 3))));
  EXPECT_FALSE(by_ever_free(looks(hits_then_passes(100, 2))));
  EXPECT_TRUE(by_ever_free(looks("hppphhhhhhhhh"))) << "whenever";
}

// As glass does, of which each beam may be sent back.
TEST(EverFree, AMeetingBetweenStartsTheCountAgain) {
  EXPECT_FALSE(by_ever_free(looks("hpphpphpphpp")));
}

// The middle row of three; 'p' passes in all of them, 'a' in all but one of the outer ones, where
// it ends beside, 'o' in the middle alone, the outer rows are not looked at.
std::vector<LaserScan> looks_in_three_rows(const std::string& looks) {
  std::vector<LaserScan> scans{rows(0.0, {3.0})};
  for (const char look : looks) {
    LaserScan& scan = scans.emplace_back(rows(static_cast<double>(scans.size()), {7.0}));
    if (look == 'a') scan.ranges[1] = 3.0;
    if (look == 'o') scan.ranges[1] = scan.ranges[2] = 0.0;
  }
  return scans;
}

EverFree with_all_about(int scans, bool same_scan = false) {
  return EverFree({.scans = scans,
                   .same_scan = same_scan,
                   .sensor_margin = 0.0,
                   .pose_margin = 1,
                   .resolution = 1.0});
}

TEST(EverFree, AllAboutAPlaceMustBeFreeToo) {
  EXPECT_TRUE(is_taken_for_dynamic(with_all_about(2), looks_in_three_rows("pp")));
  EXPECT_FALSE(is_taken_for_dynamic(with_all_about(2), looks_in_three_rows("oooo")))
      << "what nobody looked at is not free";
  EXPECT_FALSE(is_taken_for_dynamic(with_all_about(2), looks_in_three_rows("papa")));
}

TEST(EverFree, WhatIsAboutAPlaceMayBeSeenByOtherScansUnlessTheSameOneIsAskedFor) {
  EXPECT_TRUE(is_taken_for_dynamic(with_all_about(1), looks_in_three_rows("ppo")));
  EXPECT_TRUE(is_taken_for_dynamic(with_all_about(1, true), looks_in_three_rows("p")));
  std::vector<LaserScan> one_row_each = looks_in_three_rows("ppp");
  for (std::size_t i = 1; i < one_row_each.size(); ++i) {
    for (std::size_t n = 0; n < 3; ++n) {
      if (n != i - 1) one_row_each[i].ranges[n] = 0.0;
    }
  }
  // The middle row comes last, when the others have been seen.
  std::swap(one_row_each[1].ranges, one_row_each[3].ranges);
  EXPECT_TRUE(is_taken_for_dynamic(with_all_about(1), one_row_each));
  EXPECT_FALSE(is_taken_for_dynamic(with_all_about(1, true), one_row_each));
}

// Cells of 1 m; beams end in the middle of the fourth, 3.5 m from the first one's border. Those
// that end 1 m behind it leave it free by a margin below half a metre.
TEST(EverFree, TheLastStretchBeforeAHitIsNotFree) {
  const auto is_free = [](double margin) {
    const std::vector<LaserScan> scans{rows(0.0, {3.0}), rows(1.0, {4.0})};
    return is_taken_for_dynamic(
        EverFree({.scans = 1, .sensor_margin = margin, .pose_margin = 0, .resolution = 1.0}),
        scans);
  };
  EXPECT_TRUE(is_free(0.4));
  EXPECT_FALSE(is_free(0.6));
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
