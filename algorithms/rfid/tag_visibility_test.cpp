#include "algorithms/rfid/tag_visibility.h"

#include <gtest/gtest.h>

namespace mapbed {
namespace {

// Two rooms of 3 m x 3 m with a wall between them at x = 3 m, whose door is at y from 1 m to 2 m.
OccupancyMap two_rooms() {
  OccupancyMap map(GridFrame{.resolution = 0.1});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 60; ++x) {
      const bool is_wall = x == 30 && (y < 10 || y >= 20);
      map.at({x, y}) = known(is_wall ? 0.9 : 0.1);
    }
  }
  return map;
}

bool sees(const TagVisibility& visibility, const Eigen::Vector2d& place, std::uint32_t tag) {
  for (const std::uint32_t seen : visibility.from(place)) {
    if (seen == tag) return true;
  }
  return false;
}

TEST(TagVisibility, TagsAreSeenInTheirRoomAndThroughTheDoor) {
  const std::vector<Eigen::Vector2d> tags{{0.05, 0.5}, {5.95, 1.5}, {3.6, 0.5}};
  const TagVisibility visibility(two_rooms(), tags, 10.0);
  EXPECT_TRUE(sees(visibility, {1.5, 0.5}, 0));
  EXPECT_FALSE(sees(visibility, {5.5, 0.25}, 0));
  EXPECT_TRUE(sees(visibility, {0.5, 1.6}, 1));   // through the door
  EXPECT_FALSE(sees(visibility, {1.5, 0.2}, 2));  // behind the wall, though near
  EXPECT_TRUE(sees(visibility, {5.5, 0.5}, 2));
}

TEST(TagVisibility, EndsAtItsDistanceAndWhereNothingIsFree) {
  const std::vector<Eigen::Vector2d> tags{{0.05, 0.5}};
  const TagVisibility visibility(two_rooms(), tags, 2.0);
  EXPECT_TRUE(sees(visibility, {1.0, 0.5}, 0));
  EXPECT_FALSE(sees(visibility, {2.8, 0.5}, 0));
  EXPECT_TRUE(visibility.from({-5.0, 0.5}).empty());
}

}  // namespace
}  // namespace mapbed
