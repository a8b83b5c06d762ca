#include "bench/metrics/map_error.h"

#include <cmath>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

// A wall at x = 5, cells of 1 m, ten high.
TrueMap true_wall() {
  TrueMap truth{.resolution = 1.0, .width = 10, .height = 10};
  truth.cells.assign(100, TrueCell::free);
  for (int y = 0; y < 10; ++y) truth.cells[truth.index(5, y)] = TrueCell::occupied;
  return truth;
}

// All cells known, a wall at x from y = 0 on.
OccupancyMap map_with_wall(int wall_x, int wall_height) {
  OccupancyMap map(1.0);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) {
      map.at({x, y}) = known(x == wall_x && y < wall_height ? 0.9 : 0.1);
    }
  }
  return map;
}

TEST(MapError, AWallMayBeOffByOneCell) {
  EXPECT_DOUBLE_EQ(compare_maps(map_with_wall(5, 10), true_wall()).f1(), 1.0);
  EXPECT_DOUBLE_EQ(compare_maps(map_with_wall(6, 10), true_wall()).f1(), 1.0);
  EXPECT_DOUBLE_EQ(compare_maps(map_with_wall(7, 10), true_wall()).f1(), 0.0);
}

TEST(MapError, CountsWhatWasNotFound) {
  const MapErrors errors = compare_maps(map_with_wall(5, 4), true_wall());
  EXPECT_DOUBLE_EQ(errors.precision(), 1.0);
  EXPECT_EQ(errors.found, 5);  // four cells, and one above them within the tolerance
  EXPECT_EQ(errors.true_occupied, 10);
  EXPECT_DOUBLE_EQ(errors.f1(), 2.0 / 3.0);  // the harmonic mean of 1 and 1/2
}

TEST(MapError, WhatWasNeverSeenDoesNotCount) {
  OccupancyMap map(1.0);
  map.at({5, 0}) = known(0.9);
  const MapErrors errors = compare_maps(map, true_wall());
  EXPECT_EQ(errors.true_occupied, 2);
  EXPECT_DOUBLE_EQ(errors.f1(), 1.0);
  EXPECT_TRUE(std::isnan(compare_maps(OccupancyMap(1.0), true_wall()).f1()));
}

TEST(MapError, SpuriousCellsAreThoseWithoutATrueOneNear) {
  OccupancyMap map = map_with_wall(5, 10);
  map.at({6, 3}) = map.at({9, 9}) = map.at({1, 0}) = known(0.9);  // the first is near the wall
  EXPECT_EQ(compare_maps(map, true_wall()).spurious(), 2);
}

// Ten columns of ten cells; the truth has its wall in the sixth and does not know the last.
TEST(MapConfusion, CountsEveryCellOfWhichTheWorldKnows) {
  TrueMap truth = true_wall();
  for (int y = 0; y < 10; ++y) truth.cells[truth.index(9, y)] = TrueCell::unknown;
  OccupancyMap map = map_with_wall(4, 5);
  for (int y = 0; y < 10; ++y) map.at({0, y}) = Occupancy{};
  const MapConfusion confusion = confusion_of(map, truth);
  EXPECT_EQ(confusion.truly_free.occupied, 5);
  EXPECT_EQ(confusion.truly_free.unknown, 10);
  EXPECT_EQ(confusion.truly_free.free, 80 - 5 - 10);
  EXPECT_EQ(confusion.truly_occupied.free, 10);
  EXPECT_DOUBLE_EQ(confusion.coverage(), 70.0 / 80.0);
  EXPECT_DOUBLE_EQ(confusion.free_as_occupied(), 5.0 / 70.0);
  EXPECT_DOUBLE_EQ(confusion.occupied_as_free(), 1.0);
}

}  // namespace
}  // namespace mapbed
