#include "algorithms/localization/global_localizer.h"

#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/testing/furnished_room.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

const TestLaser kLaser{.beams = 361, .first_bearing = -kPi, .max_range = 10.0};

std::vector<Eigen::Vector2d> hits_at(const TestRoom& room, const Pose2& pose) {
  return hit_points(scan_of(room, pose, kLaser), {.min_spacing = 0.1, .max_points = 90});
}

GlobalLocalizer search_in(const TestRoom& room, const std::vector<Pose2>& path,
                          const RelocalizationOptions& options = {}) {
  std::vector<SurfacePoint> map;
  for (const Pose2& pose : path) {
    const std::vector<SurfacePoint> seen =
        transformed(surface_points(scan_of(room, pose, kLaser), 30.0, 0.2, 0.05), pose);
    map.insert(map.end(), seen.begin(), seen.end());
  }
  return GlobalLocalizer(map, path, options);
}

const std::vector<Pose2> kRound{{-3, -2, 0}, {0, -2, 0}, {3, -2, 0}, {3, 2, kPi / 2}, {-3, 2, kPi}};

TEST(GlobalLocalizer, FindsAScanAnywhereInTheMapWithAnyHeading) {
  const TestRoom room = furnished_room();
  const GlobalLocalizer search = search_in(room, kRound);
  for (const Pose2& truth : {Pose2{2.2, 0.7, 2.5}, Pose2{-2.4, 1.1, -1.0}, Pose2{0.3, -1.2, 0.1}}) {
    const GlobalLocalizer::Answer place = search.find(hits_at(room, truth), {-3.0, -2.0, 0.0});
    EXPECT_FALSE(place.confirmed);
    ASSERT_TRUE(place.relocated_to);
    // Half a cell of the map that is searched, and what half of that is at 5 m.
    EXPECT_THAT(*place.relocated_to, IsNear(truth, Tolerance{0.05, 0.01}));
  }
}

TEST(GlobalLocalizer, KnowsThatTheRobotIsWhereItIsTakenToBe) {
  const TestRoom room = furnished_room();
  const Pose2 truth{2.2, 0.7, 2.5};
  const GlobalLocalizer::Answer place =
      search_in(room, kRound).find(hits_at(room, truth), truth * Pose2{0.2, 0, 0.1});
  EXPECT_TRUE(place.confirmed);
  EXPECT_FALSE(place.relocated_to);
}

// The same after half a turn, but for a box that a handful of beams hit: enough to prefer one
// place, too little to be sure of it.
TEST(GlobalLocalizer, GivesNoAnswerWhereTwoPlacesLookNearlyAlike) {
  TestRoom room = rectangular_room(8.0, 5.0);
  room.add_box({-2.0, 2.3}, 0.4, 0.4);
  const std::vector<Pose2> path{{-1, 0, 0}, {1, 0, 0}};
  const Pose2 truth{1.5, 0.5, 0.3};
  const auto elsewhere = [&](double min_odds) {
    return search_in(room, path, {.min_odds = min_odds})
        .find(hits_at(room, truth), {-1.0, 0.0, 0.0})
        .relocated_to;
  };
  const std::optional<Pose2> likelier = elsewhere(1.0);
  ASSERT_TRUE(likelier);
  EXPECT_THAT(*likelier, IsNear(truth, Tolerance{0.05, 0.01}));
  EXPECT_FALSE(elsewhere(RelocalizationOptions{}.min_odds));
}

TEST(GlobalLocalizer, GivesNoAnswerAlongACorridor) {
  const TestRoom room = corridor(40.0);
  std::vector<Pose2> path;
  for (int i = -12; i <= 12; i += 2) path.push_back({1.0 * i, 0.0, 0.0});
  const GlobalLocalizer search = search_in(room, path);
  EXPECT_FALSE(search.find(hits_at(room, {3.0, 0.2, 0.1}), {-5.0, 0.0, 0.0}).relocated_to);
}

TEST(GlobalLocalizer, GivesNoAnswerWhereTheScanIsNotOfThisMap) {
  const GlobalLocalizer search = search_in(furnished_room(), kRound);
  TestRoom elsewhere = rectangular_room(7.0, 3.0);
  elsewhere.add_box({2.0, 0.5}, 0.6, 0.9, 0.4);
  for (const auto& points : {hits_at(elsewhere, {0.0, 0.0, 0.0}), {}}) {
    const GlobalLocalizer::Answer place = search.find(points, {0.0, 0.0, 0.0});
    EXPECT_FALSE(place.confirmed);
    EXPECT_FALSE(place.relocated_to);
  }
}

}  // namespace
}  // namespace mapbed
