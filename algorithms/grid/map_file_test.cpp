#include "algorithms/grid/map_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/grid/map_image.h"
#include "algorithms/grid/testing/drawing.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/image/png.h"
#include "core/image/pnm.h"
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
  const GrayImage image = read_pgm(path("map.pgm"));
  EXPECT_EQ(image.at(0, 2), 0) << "y is up: the lower left cell is in the last row";
  EXPECT_EQ(image.at(8, 0), 254);
  EXPECT_EQ(image.at(1, 1), 205);
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

TEST_F(MapFile, ReadsAMapWhosePictureIsAPng) {
  const std::string yaml = foreign("foreign.pgm", "foreign.png");
  write_png(path("foreign.png"), read_pgm(path("foreign.pgm")));
  EXPECT_EQ(drawing_of(read_map(yaml), {{-20, 40}, {-19, 41}}), "#.|. |");
}

TEST_F(MapFile, RefusesWhatItCannotRead) {
  EXPECT_INPUT_ERROR(read_map(path("missing.yaml")), "missing.yaml");
  EXPECT_INPUT_ERROR(read_map(foreign("foreign.pgm", "gone.pgm")), "gone.pgm");
  EXPECT_INPUT_ERROR(read_map(foreign("0.05", "-0.05")), "foreign.yaml:2");
  EXPECT_INPUT_ERROR(read_map(foreign("0.05", "nan")), "foreign.yaml:2");
  EXPECT_INPUT_ERROR(read_map(foreign(", 0.0]", "]")), "foreign.yaml:3: origin has 2 numbers");
  EXPECT_INPUT_ERROR(read_map(foreign(", 0.0]", ", 0.3]")), "turned by 0.3 rad");
  EXPECT_INPUT_ERROR(read_map(foreign("0.65", "0.1")), "free_thresh is not below occupied_thresh");
  EXPECT_INPUT_ERROR(read_map(foreign("negate: 0", "negate: 0\nmode: raw")),
                     "maps of mode 'raw' cannot be read");
  EXPECT_INPUT_ERROR(read_map(foreign("negate: 0\n", "")), "negate");
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

}  // namespace
}  // namespace mapbed
