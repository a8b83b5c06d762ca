#include "algorithms/grid/end_point_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/testing/drawing.h"

namespace mapbed {
namespace {

TEST(EndPointMap, KnowsEndPointsOnly) {
  EndPointMap map(GridFrame{.resolution = 1.0});
  map.insert({{0.5, 0.5}, {4.5, 0.5}});
  map.insert({{0.5, 0.5}, {2.5, 0.5}, /*hit=*/false});
  EXPECT_EQ(drawing_of(map.occupancy_by_counting(), {{0, 0}, {5, 0}}), "    # |");
}

TEST(EndPointMap, CountingMarksACellWhateverTheNumberOfEndPoints) {  // (2.17)
  EndPointMap map(GridFrame{.resolution = 1.0});
  for (int i = 0; i < 3; ++i) map.insert({{0.5, 0.5}, {4.5, 0.5}});
  map.insert({{0.5, 0.5}, {5.5, 0.5}});
  EXPECT_EQ(map.occupancy_by_counting()[(CellIndex{4, 0})].probability, 1.0F);
  EXPECT_EQ(map.occupancy_by_counting()[(CellIndex{5, 0})].probability, 1.0F);
}

TEST(EndPointMap, OddsGrowWithEachEndPoint) {  // (2.16) put right: odds 4, then 16
  EndPointMap map(GridFrame{.resolution = 1.0});
  map.insert({{0.5, 0.5}, {4.5, 0.5}});
  EXPECT_FLOAT_EQ(map.occupancy_by_odds({})[(CellIndex{4, 0})].probability, 0.8F);
  map.insert({{0.5, 0.5}, {4.5, 0.5}});
  EXPECT_FLOAT_EQ(map.occupancy_by_odds({})[(CellIndex{4, 0})].probability, 16.0F / 17.0F);
  EXPECT_FLOAT_EQ(map.occupancy_by_odds({.highest = 0.9})[(CellIndex{4, 0})].probability, 0.9F);
}

TEST(EndPointMap, HoldsMemoryAtEndPointsOnly) {
  EndPointMap map(GridFrame{.resolution = 0.05});
  map.insert({{0.0, 0.0}, {1000.0, 0.0}});
  EXPECT_EQ(map.occupancy_by_counting().tile_count(), 1U);
}

}  // namespace
}  // namespace mapbed
