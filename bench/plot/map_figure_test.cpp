#include "bench/plot/map_figure.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "bench/plot/map_raster.h"

namespace mapbed {
namespace {

// A free room of that many metres with a wall of one cell on its lower edge.
OccupancyMap room(double resolution, double width, double height) {
  OccupancyMap map(resolution);
  const int columns = static_cast<int>(width / resolution + 0.5);
  const int rows = static_cast<int>(height / resolution + 0.5);
  for (int x = 0; x < columns; ++x) {
    for (int y = 0; y < rows; ++y) map.at({x, y}) = known(y == 0 ? 1.0 : 0.0);
  }
  return map;
}

// Lengths of the runs of black along each row of the upper part, the longest first.
std::vector<int> walls(const RgbImage& image, int rows) {
  std::vector<int> lengths;
  for (int y = 0; y < rows; ++y) {
    int length = 0;
    for (int x = 0; x <= image.width(); ++x) {
      if (x < image.width() && image.at(x, y) == kBlack) {
        ++length;
      } else if (length > 0) {
        lengths.push_back(length);
        length = 0;
      }
    }
  }
  std::sort(lengths.rbegin(), lengths.rend());
  return lengths;
}

constexpr int kBelow = 70;  // [pixels] at the bottom: scale bar and legend

TEST(MapFigure, ShowsAllMapsAtOneScaleWhateverTheirResolutions) {
  const std::vector<NamedMap> maps = {{"", room(0.1, 12.0, 10.0)}, {"", room(0.25, 6.0, 10.0)}};
  const RgbImage figure = figure_of(maps, 540);
  const std::vector<int> lengths = walls(figure, figure.height() - kBelow);
  // 18 m in 540 pixels are 30 pixels for a metre: 3 for a cell of 10 cm.
  ASSERT_FALSE(lengths.empty());
  EXPECT_EQ(lengths.front(), 360);
  EXPECT_NE(std::find(lengths.begin(), lengths.end(), 180), lengths.end());
}

TEST(MapFigure, StandsWideMapsOnTopOfEachOtherAndTallOnesBesideEachOther) {
  const auto longest_wall = [](double width, double height) {
    const RgbImage figure =
        figure_of(std::vector<NamedMap>(3, {"", room(0.1, width, height)}), 540);
    return walls(figure, figure.height() - kBelow).front();
  };
  // In a row 36 m would be 540 pixels; below each other 12 m are, of 4 whole pixels for a cell.
  EXPECT_EQ(longest_wall(12.0, 2.0), 480);
  // 6 m in a row, not 24 m: the height of 8 m, of 6 whole pixels for a cell.
  EXPECT_EQ(longest_wall(2.0, 8.0), 120);
}

TEST(MapFigure, KeepsThinWallsWhereAPixelHoldsManyCells) {
  const std::vector<NamedMap> maps = {{"", room(0.05, 40.0, 40.0)}, {"", room(0.03, 30.0, 40.0)}};
  const RgbImage figure = figure_of(maps, 140);
  const std::vector<int> lengths = walls(figure, figure.height() - kBelow);
  // 70 m in 140 pixels, of 10 and of 17 cells.
  ASSERT_FALSE(lengths.empty());
  EXPECT_EQ(lengths.front(), 80);
  EXPECT_NE(std::find(lengths.begin(), lengths.end(), 60), lengths.end());
}

TEST(MapFigure, HasRoomForNamesThatAreLongerThanTheirMaps) {
  const std::string name = "a map that is small, and has a name that is not";
  const std::vector<NamedMap> one = {{name, room(0.1, 1.0, 1.0)}};
  const std::vector<NamedMap> two = {{name, room(0.1, 1.0, 1.0)}, {name, room(0.1, 1.0, 1.0)}};
  EXPECT_GT(figure_of(two, 400).width(), figure_of(one, 400).width() + 150);
}

TEST(MapFigure, ShowsWhatMetWhatMovesWithItsLegend) {
  NamedMap map{"", room(0.1, 12.0, 14.0)};
  const auto orange = [&] {
    const RgbImage figure = figure_of({map, map}, 960);  // 4 pixels for a cell
    const std::vector<Rgb>& pixels = figure.pixels();
    return std::count(pixels.begin(), pixels.end(), kDynamicColor);
  };
  EXPECT_EQ(orange(), 0);
  map.dynamic = {"met what moves", {{3.05, 2.05}, {50.0, 2.0}}};
  const auto in_legend = orange() - 2 * 4 * 4;
  EXPECT_GT(in_legend, 100);
  map.dynamic.points.emplace_back(3.15, 2.05);
  EXPECT_EQ(orange() - in_legend, 2 * 4 * 8);
}

TEST(MapFigure, IsDrawnOfAMapOfWhichNothingIsKnown) {
  EXPECT_GT(figure_of({{"nothing", OccupancyMap(0.1)}}, 400).width(), 0);
}

}  // namespace
}  // namespace mapbed
