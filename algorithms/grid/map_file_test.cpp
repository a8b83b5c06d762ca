#include "algorithms/grid/map_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/map_image.h"
#include "algorithms/grid/testing/drawing.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/geometry/angle.h"
#include "core/image/pgm.h"
#include "core/image/png.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

constexpr const char* kDrawing =
    "#### |"
    "#..# |"
    "# .##|";

class MapFile : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  // A 2 x 2 map file, written by somebody else, with one line of it changed.
  std::string foreign(const std::string& from = "", const std::string& to = "") const {
    GrayImage image(2, 2, 254);
    image.at(0, 0) = 0;
    image.at(1, 1) = 205;
    write_pgm(path("foreign.pgm"), image);
    std::string yaml =
        "image: foreign.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    const std::size_t at = yaml.find(from);
    yaml.replace(at, from.size(), to);
    write_file(path("foreign.yaml"), yaml);
    return path("foreign.yaml");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(MapFile, ReadBackHasTheSameCellsAtTheSamePlace) {
  OccupancyMap map = map_of(kDrawing, GridFrame{.resolution = 0.05});
  map.at({-70, 33}) = known(1.0);
  write_map(path("map"), map);
  const OccupancyMap again = read_map(path("map.yaml"));
  EXPECT_EQ(known_box(again), known_box(map));
  EXPECT_EQ(drawing_of(again), drawing_of(map));
  EXPECT_EQ(again.resolution(), 0.05);
  EXPECT_EQ(again.frame().origin, map.frame().origin);
}

TEST_F(MapFile, WrittenAgainIsTheSameFile) {
  const OccupancyMap map = map_of(kDrawing, GridFrame{.resolution = 0.1, .origin = {0.03, -7.77}});
  write_map(path("map"), map);
  const std::string yaml = read_text_file(path("map.yaml"));
  const std::string pgm = read_text_file(path("map.pgm"));
  write_map(path("map"), read_map(path("map.yaml")));
  EXPECT_EQ(read_text_file(path("map.yaml")), yaml);
  EXPECT_EQ(read_text_file(path("map.pgm")), pgm);
}

TEST_F(MapFile, SaysInTheUsualWordsWhereThePictureLies) {
  OccupancyMap map(0.5);
  map.at({-3, 4}) = known(1.0);
  map.at({5, 6}) = known(0.0);
  write_map(path("map"), map);
  EXPECT_EQ(read_text_file(path("map.yaml")),
            "image: map.pgm\nmode: trinary\nresolution: 0.5\norigin: [-1.5, 2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const Samples image = read_samples(path("map.pgm"));
  EXPECT_EQ(*image.pixel(0, 2), 0) << "y is up: the lower left cell is in the last row";
  EXPECT_EQ(*image.pixel(8, 0), 254);
  EXPECT_EQ(*image.pixel(1, 1), 205);
}

TEST_F(MapFile, WhatLiesBetweenTheThresholdsIsUnknown) {
  OccupancyMap map(1.0);
  const double probabilities[] = {0.0, 0.19, 0.2, 0.5, 0.65, 0.66, 1.0};
  for (int x = 0; x < 7; ++x) map.at({x, 0}) = known(probabilities[x]);
  write_map(path("map"), map);
  EXPECT_EQ(drawing_of(read_map(path("map.yaml")), {{0, 0}, {6, 0}}), "..   ##|");
}

TEST_F(MapFile, ReadsMapsOfOthers) {
  EXPECT_EQ(drawing_of(read_map(foreign()), {{-20, 40}, {-19, 41}}), "#.|. |");
  EXPECT_EQ(drawing_of(read_map(foreign("negate: 0", "negate: 1")), {{-20, 40}, {-19, 41}}),
            ".#|##|");  // 205 of 255 is occupied when white means so
  const OccupancyMap shifted = read_map(foreign("[-1.0", "[-1.02"));
  EXPECT_EQ(drawing_of(shifted), "#.|. |");
  EXPECT_NEAR(shifted.frame().corner_of({0, 0}).x(), -1.02, 1e-12);
}

TEST_F(MapFile, AQuarterTurnMovesEveryCell) {
  // The picture's lower left corner stays at (-1, 2), its x goes up now and its y to the left.
  const OccupancyMap map = read_map(foreign(", 0.0]", ", 1.5707963267948966]"));
  EXPECT_EQ(known_box(map), (CellBox{{-22, 40}, {-21, 41}}));
  EXPECT_EQ(drawing_of(map, {{-22, 40}, {-21, 41}}), ". |#.|");
}

TEST_F(MapFile, AWallStaysClosedHoweverItIsTurned) {
  GrayImage image(40, 3, 254);
  for (int x = 0; x < 40; ++x) image.at(x, 1) = 0;
  for (int degree = -170; degree <= 180; degree += 10) {
    const std::string yaml = foreign(", 0.0]", ", " + std::to_string(radians(degree)) + "]");
    write_pgm(path("foreign.pgm"), image);
    const OccupancyMap map = read_map(yaml);
    const Pose2 map_from_image{-1.0, 2.0, radians(degree)};
    for (double x = 0.1; x < 1.9; x += 0.01) {  // [m] along the wall's middle
      const CellIndex cell = map.cell_of(map_from_image * Eigen::Vector2d(x, 0.075));
      bool wall_near = false;
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const Occupancy& near = map[{cell.x + i, cell.y + j}];
          wall_near = wall_near || (near.known() && near.probability == 1.0F &&
                                    (map.center_of({cell.x + i, cell.y + j}) -
                                     map_from_image * Eigen::Vector2d(x, 0.075))
                                            .norm() < 0.05);
        }
      }
      EXPECT_TRUE(wall_near) << degree << " degrees, " << x << " m";
    }
  }
}

TEST_F(MapFile, APictureOfAMapKeepsHowLikelyItsCellsAreOccupied) {
  OccupancyMap map(GridFrame{.resolution = 0.05});
  for (int x = 0; x < 5; ++x) map.at({x, 7}) = known(0.2 * x);
  map.at({6, 7}) = known(1.0);  // (5, 7) stays unknown
  write_map(path("map"), map);
  write_png(path("map.png"), to_image(map));
  const OccupancyMap again = read_map(path("map.png"));
  EXPECT_EQ(known_box(again), known_box(map));
  for (int x = 0; x < 5; ++x) {
    const double step = 1.0 / 255.0;  // the unknown's grey, 0.196, is passed over
    EXPECT_NEAR((again[{x, 7}].probability), 0.2 * x, x == 1 ? 1.5 * step : 0.5 * step) << x;
  }
  EXPECT_FALSE((again[{5, 7}].known()));
  const OccupancyMap at_origin = read_map(path("map.png"), 0.1);
  EXPECT_EQ(known_box(at_origin), (CellBox{{0, 0}, {6, 0}}));
  EXPECT_EQ(at_origin.resolution(), 0.1);
}

TEST_F(MapFile, APictureThatTheFileBesideItNamesIsReadAsTheFileSays) {
  const std::string yaml = foreign("negate: 0", "negate: 1");
  EXPECT_EQ(drawing_of(read_map(path("foreign.pgm"))), drawing_of(read_map(yaml)));
}

TEST_F(MapFile, RefusesWhatItCannotRead) {
  EXPECT_INPUT_ERROR(read_map(path("missing.yaml")), "missing.yaml");
  EXPECT_INPUT_ERROR(read_map(path("missing.png")), "missing.png: no such file");
  EXPECT_INPUT_ERROR(read_map(foreign("0.05", "nan")), "foreign.yaml:2");
  write_pgm(path("alone.pgm"), GrayImage(1, 1));
  EXPECT_INPUT_ERROR(read_map(path("alone.pgm")), "does not say how large its cells are");
  write_pgm(path("long.pgm"), GrayImage(300'000, 1));
  EXPECT_INPUT_ERROR(read_map(path("long.pgm"), 0.05), "cells is too long");
}

TEST(MapImage, ShowsUnknownApartFromAnyKnownCell) {
  OccupancyMap map(1.0);
  for (int x = 0; x <= 1000; ++x) map.at({x, 0}) = known(x / 1000.0);
  const GrayImage image = to_image(map, {{0, 0}, {1001, 0}});
  for (int x = 0; x <= 1000; ++x) {
    EXPECT_NE(image.at(x, 0), kUnknownGrey);
    EXPECT_NEAR(image.at(x, 0), 255 * (1 - x / 1000.0), 1.5);  // half a step, or one aside
  }
  EXPECT_EQ(image.at(1001, 0), kUnknownGrey);
}

TEST(MapImage, HasYUpAndShowsTheKnownCells) {
  const GrayImage image = to_image(map_of("#.|  |. |", GridFrame{.resolution = 1.0}));
  EXPECT_EQ(image.width(), 2);
  EXPECT_EQ(image.height(), 3);
  EXPECT_EQ(image.at(0, 0), 0);
  EXPECT_EQ(image.at(1, 0), 255);
  EXPECT_EQ(image.at(0, 2), 255);
  EXPECT_EQ(image.at(1, 1), kUnknownGrey);
}

TEST(MapImage, RefusesMapsThatMakeNoPicture) {
  OccupancyMap map(0.05);
  EXPECT_INPUT_ERROR(to_image(map), "the map has no known cell");
  map.at({0, 0}) = known(0.0);
  map.at({20'000, 20'000}) = known(0.0);
  EXPECT_INPUT_ERROR(to_image(map), "20001 x 20001 cells of 0.05 m, too large for a picture");
  EXPECT_INPUT_ERROR(image_box(map, "map.pgm"), "map.pgm is 20001 x 20001 cells");
}

TEST_F(MapFile, AMapThatIsLongAndAslantIsRefusedAndNotLookedThroughForHours) {
  MapServerMap map{.occupancy = Image<float>(200'000, 1, 1.0F), .resolution = 0.05};
  EXPECT_EQ(known_box(occupancy_map_of(map)).width(), 200'000);
  map.map_from_image.theta = 0.7;
  EXPECT_INPUT_ERROR(occupancy_map_of(map), "a map of 200000 x 1 cells is too long to be turned");
}

}  // namespace
}  // namespace mapbed
