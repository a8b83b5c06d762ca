#include "algorithms/submaps/submap_matcher.h"

#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr double kWindow = 3.0, kTurnWindow = 1.0;

const TestLaser kLaser{.beams = 360, .first_bearing = -kPi, .max_range = 15.0};

// Of scans along a line, half a metre apart; its frame is `map_from_submap`.
Submap submap_along(const TestRoom& room, const Pose2& map_from_submap, int scans = 6) {
  std::vector<SubmapScan> taken;
  for (int i = 0; i < scans; ++i) {
    const Pose2 submap_from_robot{0.5 * (i - scans / 2), 0.0, 0.0};
    const LaserScan scan = scan_of(room, map_from_submap * submap_from_robot, kLaser);
    taken.push_back(
        {submap_from_robot, surface_points(scan, 30.0, 0.2, 0.1), ScanExtent(scan, 30.0, 20.0)});
  }
  return make_submap(taken, {});
}

std::optional<SubmapMatch> matched(const Submap& target, const Submap& query,
                                   const Pose2& predicted, Rivals rivals = Rivals::searched) {
  return match_submaps(target, make_field(target, {}, kWindow), query,
                       make_field(query, {}, kWindow), predicted, kWindow, kTurnWindow, {}, rivals);
}

TEST(SubmapMatcher, FindsWhereOneMapLiesInAnother) {
  const TestRoom room = furnished_room();
  const Pose2 map_from_target{-1.0, 0.5, 0.3}, map_from_query{1.2, -0.4, 1.0};
  const Pose2 truth = motion_between(map_from_target, map_from_query);
  const auto match = matched(submap_along(room, map_from_target),
                             submap_along(room, map_from_query), truth * Pose2{1.5, -1.0, 0.5});
  ASSERT_TRUE(match.has_value());
  EXPECT_THAT(match->target_from_query, IsNear(truth, {.position = 0.02, .heading = 0.005}));
  EXPECT_TRUE(match->is_unique);
  EXPECT_GT(match->agreement.ratio(), 0.97);
  EXPECT_GT(match->agreement.overlap(), 0.8);
  // Walls on all sides: as exact as cells allow.
  EXPECT_LT(match->covariance(0, 0), 0.05 * 0.05);
  EXPECT_LT(match->covariance(1, 1), 0.05 * 0.05);
}

// 6.3.4: a wall where the other one looked through speaks against a pose.
TEST(SubmapMatcher, WhatOneLookedThroughContradicts) {
  const TestRoom room = furnished_room();
  TestRoom crossed = room;
  crossed.add({{-6.0, 1.5}, {6.0, 1.5}});
  const Submap open = submap_along(room, {}), closed = submap_along(crossed, {0.2, 0.0, 0.0});
  const Agreement alike = agreement(open, make_field(open, {}, kWindow).field, open,
                                    make_field(open, {}, kWindow).field, {}, {});
  EXPECT_DOUBLE_EQ(alike.ratio(), 1.0);
  const Agreement apart = agreement(open, make_field(open, {}, kWindow).field, closed,
                                    make_field(closed, {}, kWindow).field, {0.2, 0.0, 0.0}, {});
  EXPECT_LT(apart.ratio(), 0.9);
  EXPECT_GT(apart.contradicted, 40.0);
}

TEST(SubmapMatcher, AnotherPlaceIsNotFound) {
  const Submap target = submap_along(furnished_room(), {});
  TestRoom other = rectangular_room(4.0, 20.0);
  other.add_box({1.0, 2.0}, 0.5, 0.5);
  EXPECT_FALSE(matched(target, submap_along(other, {}), {}).has_value());
}

// Any place along a bare corridor is as good as another.
TEST(SubmapMatcher, ACorridorIsNotUniqueAlongItself) {
  const TestRoom bare = corridor(60.0);
  const auto match =
      matched(submap_along(bare, {}), submap_along(bare, {1.0, 0.0, 0.0}), {1.0, 0.0, 0.0});
  ASSERT_TRUE(match.has_value());
  EXPECT_FALSE(match->is_unique);
  EXPECT_GT(match->covariance(0, 0), 1000.0 * match->covariance(1, 1));
}

TEST(SubmapMatcher, WithoutRivalsFindsTheSamePlace) {
  const TestRoom bare = corridor(60.0);
  const Submap target = submap_along(bare, {}), query = submap_along(bare, {1.0, 0.0, 0.0});
  const auto match = matched(target, query, {1.0, 0.0, 0.0}, Rivals::ignored);
  const auto beside_others = matched(target, query, {1.0, 0.0, 0.0});
  ASSERT_TRUE(match.has_value() && beside_others.has_value());
  EXPECT_EQ(match->target_from_query, beside_others->target_from_query);
  EXPECT_EQ(match->covariance, beside_others->covariance);
  EXPECT_TRUE(match->is_unique);
}

TEST(SubmapMatcher, AnEmptyMapMatchesNothing) {
  const Submap target = submap_along(furnished_room(), {});
  Submap empty = target;
  empty.surface.clear();
  EXPECT_FALSE(matched(target, empty, {}).has_value());
  EXPECT_FALSE(matched(empty, target, {}).has_value());
}

}  // namespace
}  // namespace mapbed
