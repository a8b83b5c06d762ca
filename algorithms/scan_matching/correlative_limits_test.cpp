#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/search_lattice.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// In the middle of a room that looks the same after half a turn.
class SearchWithinLimits : public ::testing::Test {
 protected:
  SearchWithinLimits() {
    const LaserScan scan = scan_of(rectangular_room(5.0, 3.0), kTruth, kAllRound);
    field_.add(transformed(surface_points(scan, 30.0, 0.2, 0.05), kTruth));
    points_ = to_field_points(hit_points(scan, {.min_spacing = 0.2}), field_.resolution());
  }
  LimitedSearch search(const SearchLimits& limits) const {
    return best_match_within(points_, field_, make_bound_pyramid(field_, kLattice.window),
                             {.mean = kTruth}, kLattice, limits);
  }
  std::optional<ScanMatch> found(const SearchLimits& limits) const { return search(limits).match; }

  const TestLaser kAllRound{.beams = 360, .first_bearing = -kPi};
  const Pose2 kTruth{0.3, 0.0, 0.0};
  const Pose2 kTwin{-0.3, 0.0, kPi};
  const Tolerance kLatticeStep{0.051, 0.051};  // a cell, a turn
  const CorrelativeMatcherOptions kLattice{.window = 0.8, .turn_window = kPi, .turn_step = 0.05};
  LikelihoodField field_;
  FieldPoints points_;
};

TEST_F(SearchWithinLimits, WithoutThemFindsTheBestPose) {
  const std::optional<ScanMatch> match = found({});
  ASSERT_TRUE(match);
  EXPECT_THAT(match->map_from_robot, IsNear(kTruth, kLatticeStep));
}

TEST_F(SearchWithinLimits, AnswersWithABetterPoseOnly) {
  const double best = found({})->log_posterior;
  const std::optional<ScanMatch> same = found({.above = best - 1e-6});
  ASSERT_TRUE(same);
  EXPECT_EQ(same->log_posterior, best);
  EXPECT_FALSE(found({.above = best}));
}

TEST_F(SearchWithinLimits, FindsTheNextPlaceAwayFromTheBest) {
  const std::optional<ScanMatch> other =
      found({.away_from = kTruth, .distance = 0.4, .turn = 0.35});
  ASSERT_TRUE(other);
  EXPECT_THAT(other->map_from_robot, IsNear(kTwin, kLatticeStep));
}

// Whole blocks are left out where all their poses are too near, and none that has another one.
TEST_F(SearchWithinLimits, AwayFromAPoseFindsTheBestOfAllOthers) {
  const SearchLattice lattice = lattice_of(points_, field_.resolution(), kLattice);
  struct Tried {
    Pose2 pose;
    double value;
  };
  std::vector<Tried> all;
  for (int turn = -lattice.turns; turn <= lattice.turns; ++turn) {
    for (int y = -lattice.shifts; y <= lattice.shifts; ++y) {
      for (int x = -lattice.shifts; x <= lattice.shifts; ++x) {
        const Pose2 pose = lattice.pose(kTruth, field_.resolution(), turn, x, y);
        all.push_back({pose, field_.sum_log_at(points_, pose)});
      }
    }
  }
  for (const double distance : {0.06, 0.2, 0.4, 0.9}) {
    for (const double turn : {0.06, 0.35, 2.0, kPi}) {
      const SearchLimits limits{
          .away_from = kTruth * Pose2{0.02, 0.01, 0.02}, .distance = distance, .turn = turn};
      double best = -1e300;
      for (const Tried& tried : all) {
        if (!limits.exclude(tried.pose)) best = std::max(best, tried.value);
      }
      const std::optional<ScanMatch> match = found(limits);
      ASSERT_TRUE(match) << distance << ' ' << turn;
      EXPECT_DOUBLE_EQ(match->log_likelihood, best) << distance << ' ' << turn;
    }
  }
}

TEST_F(SearchWithinLimits, APoseIsAwayByItsPlaceOrByItsHeading) {
  const SearchLimits limits{.away_from = kTruth, .distance = 0.4, .turn = 0.35};
  EXPECT_TRUE(limits.exclude(kTruth * Pose2{0.3, 0.0, 0.3}));
  EXPECT_FALSE(limits.exclude(kTruth * Pose2{0.5, 0.0, 0.0}));
  EXPECT_FALSE(limits.exclude(kTruth * Pose2{0.0, 0.0, 0.4}));
  EXPECT_FALSE(SearchLimits{}.exclude(kTruth));
}

TEST_F(SearchWithinLimits, SaysWhereItGaveUp) {
  EXPECT_TRUE(search({}).complete);
  EXPECT_FALSE(search({.max_blocks = 10}).complete);
}

TEST_F(SearchWithinLimits, RefusesALatticeThatIsFinerThanAnySearchCanBe) {
  const CorrelativeMatcherOptions fine{.window = 0.8, .turn_window = 1.0, .turn_step = 1e-9};
  EXPECT_INPUT_ERROR(
      match_correlative(points_, field_, make_bound_pyramid(field_, 0.8), {.mean = kTruth}, fine),
      "choose a larger turn_step");
  EXPECT_INPUT_ERROR(make_bound_pyramid(field_, 10'000.0),
                     "choose larger cells or a smaller window");
}

TEST_F(SearchWithinLimits, APointlessScanHasNoAnswer) {
  points_ = {};
  EXPECT_FALSE(found({}));
}

}  // namespace
}  // namespace mapbed
