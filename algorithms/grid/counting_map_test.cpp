#include "algorithms/grid/counting_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/testing/drawing.h"

namespace mapbed {
namespace {

CountingMap empty_map(double resolution) {
  return CountingMap(GridFrame{.resolution = resolution});
}

constexpr CellBox kRow{{0, 0}, {7, 0}};

TEST(CountingMap, ABeamClearsItsPathAndFillsItsEnd) {
  CountingMap map = empty_map(/*resolution=*/1.0);
  map.insert({{0.5, 0.5}, {4.5, 0.5}});
  EXPECT_EQ(drawing_of(map.occupancy(), kRow), "....#   |");
}

TEST(CountingMap, ABeamWithoutReflectionClearsItsPathAndSaysNothingOfItsLastCell) {
  CountingMap map = empty_map(/*resolution=*/1.0);
  map.insert({{0.5, 0.5}, {4.5, 0.5}, /*hit=*/false});
  EXPECT_EQ(drawing_of(map.occupancy(), kRow), "....    |");
}

TEST(CountingMap, HoldsTheFractionOfBeamsThatACellReflects) {  // (2.15): 70 of 100 looks
  CountingMap map = empty_map(/*resolution=*/1.0);
  for (int i = 0; i < 100; ++i) map.insert({{0.5, 0.5}, {i < 70 ? 2.5 : 3.5, 0.5}});
  EXPECT_EQ(map.occupancy()[(CellIndex{2, 0})].probability, 0.7F);
  EXPECT_EQ(map.cells()[(CellIndex{2, 0})].hits, 70U);
  EXPECT_EQ(map.cells()[(CellIndex{2, 0})].misses, 30U);
}

TEST(CountingMap, ACellThatNoBeamTouchedIsUnknownNotFree) {  // (2.15): 0/0
  CountingMap map = empty_map(/*resolution=*/1.0);
  map.insert({{0.5, 0.5}, {2.5, 0.5}});
  EXPECT_FALSE(map.occupancy()[(CellIndex{3, 0})].known());     // in the same tile
  EXPECT_FALSE(map.occupancy()[(CellIndex{1000, 0})].known());  // in none
  EXPECT_EQ(map.occupancy()[(CellIndex{1, 0})].probability, 0.0F);
  EXPECT_EQ(counting_occupancy(0, 0), std::nullopt);
  EXPECT_EQ(counting_occupancy(0, 3), 0.0);
}

}  // namespace
}  // namespace mapbed
