#include "algorithms/grid/tiled_grid.h"

#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(TiledGrid, HoldsWhatWasWrittenOnAllSidesOfTheOrigin) {
  TiledGrid<int> grid(0.1);
  const std::vector<CellIndex> cells{{0, 0}, {-1, 0}, {0, -1}, {-33, 40}, {900, -700}, {31, 32}};
  for (int i = 0; i < 6; ++i) grid.at(cells[static_cast<std::size_t>(i)]) = i + 1;
  for (int i = 0; i < 6; ++i) EXPECT_EQ(grid[cells[static_cast<std::size_t>(i)]], i + 1);
  EXPECT_EQ(grid[(CellIndex{1, 0})], 0);
  EXPECT_EQ(grid[(CellIndex{-5000, 5000})], 0);
}

TEST(TiledGrid, AWriterWritesTheSameCells) {
  TiledGrid<int> grid(0.1);
  TiledGrid<int>::Writer writer(grid);
  for (int x = -100; x < 100; ++x) writer.at({x, x / 3}) += x;
  for (int x = -100; x < 100; ++x) EXPECT_EQ(grid[(CellIndex{x, x / 3})], x);
}

TEST(TiledGrid, HoldsMemoryOnlyWhereItWasWritten) {
  TiledGrid<int> grid(0.05);
  grid.at({0, 0}) = 1;
  grid.at({31, 31}) = 1;
  grid.at({20'000, 20'000}) = 1;
  EXPECT_EQ(grid.tile_count(), 2U);
  EXPECT_EQ(grid[(CellIndex{10'000, 10'000})], 0);
  EXPECT_EQ(grid.tile_count(), 2U) << "reading must not make a tile";
}

TEST(TiledGrid, ACopyIsIndependent) {
  TiledGrid<int> grid(0.1);
  grid.at({5, 5}) = 1;
  TiledGrid<int> copy = grid;
  copy.at({5, 5}) = 2;
  EXPECT_EQ(grid[(CellIndex{5, 5})], 1);
  grid = copy;
  EXPECT_EQ(grid[(CellIndex{5, 5})], 2);
}

TEST(TiledGrid, ADrainedGridVisitsTheSameCellsAndHoldsNothing) {
  TiledGrid<int> grid(0.1);
  grid.at({-40, 3}) = 1;
  grid.at({900, -700}) = 2;
  std::vector<std::pair<int, int>> visited, drained;
  const auto into = [](std::vector<std::pair<int, int>>& cells) {
    return [&cells](CellIndex cell, int value) {
      if (value != 0) cells.emplace_back(cell.x, value);
    };
  };
  grid.for_each(into(visited));
  grid.drain(into(drained));
  EXPECT_EQ(drained, visited);
  EXPECT_EQ(drained.size(), 2U);
  EXPECT_EQ(grid.tile_count(), 0U);
}

TEST(TiledGrid, KnowsTheBoxOfTheCellsAskedFor) {
  TiledGrid<int> grid(0.1);
  EXPECT_TRUE(grid.box_where([](int cell) { return cell > 0; }).empty());
  grid.at({-40, 7}) = 1;
  grid.at({3, 90}) = 1;
  grid.at({500, 500}) = -1;
  EXPECT_EQ(grid.box_where([](int cell) { return cell > 0; }), (CellBox{{-40, 7}, {3, 90}}));
}

TEST(TiledGrid, RefusesPlacesSoFarApartThatTheWayBetweenTakesAllMemory) {
  TiledGrid<int> grid(0.1);
  grid.at({0, 0}) = 1;
  EXPECT_INPUT_ERROR(grid.at({200'000'000, 200'000'000}),
                     "poses lie too far apart for a map: it would have 6250001 x 6250001 tiles");
  grid.at({2'000'000, 100}) = 1;  // 200 km along one axis alone
  EXPECT_EQ(grid[(CellIndex{2'000'000, 100})], 1);
}

TEST(GridFrame, ACellHoldsItsCenterAndItsLowerCorner) {
  const GridFrame frame{.resolution = 0.25, .origin = {-3.0, 1.0}};
  const CellIndex cell{-7, 12};
  EXPECT_EQ(frame.cell_of(frame.center_of(cell)), cell);
  EXPECT_EQ(frame.cell_of(frame.corner_of(cell)), cell);
  EXPECT_EQ(frame.cell_of({-3.0, 1.0}), (CellIndex{0, 0}));
  EXPECT_EQ(frame.cell_of({-3.01, 0.99}), (CellIndex{-1, -1}));
}

}  // namespace
}  // namespace mapbed
