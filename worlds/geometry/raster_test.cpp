#include "worlds/geometry/raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

Entity block(double x, double y, double width, double depth, double bottom, double top) {
  return {.name = "block",
          .world_from_entity = upright({x + width / 2, y + depth / 2, 0}),
          .parts = {{.name = "block",
                     .geometry = Box{{width, depth, top - bottom}},
                     .entity_from_part = upright({}, (bottom + top) / 2)}}};
}

std::string drawing_of(const TrueMap& map) {
  std::string text;
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x) text += " .#i"[static_cast<int>(map.at(x, y))];
    text += '\n';
  }
  return text;
}

// A room of walls one metre thick with a big block in it.
World room() {
  World world;
  world.name = "room";
  world.entities = {block(0, 0, 9, 1, 0, 3), block(0, 6, 9, 1, 0, 3), block(0, 0, 1, 7, 0, 3),
                    block(8, 0, 1, 7, 0, 3), block(3, 2, 3, 3, 0, 1)};
  return world;
}

const RasterOptions kMetres{.height = 0.5, .resolution = 1.0, .margin = 0.0};

TEST(Raster, DrawsWhatCanBeReachedItsBordersAndWhatLiesBehind) {
  World world = room();
  world.paths = {{"path", {{{1.5, 1.5}}, {{7.5, 1.5}}}}};
  EXPECT_EQ(drawing_of(raster(world, kMetres)),
            "#########\n"
            "#.......#\n"
            "#..###..#\n"
            "#..#i#..#\n"
            "#..###..#\n"
            "#.......#\n"
            "#########\n");
}

TEST(Raster, LeavesUnknownWhereNoPathLeads) {
  World world = room();
  world.entities.push_back(block(3, 0, 1, 7, 0, 3));  // a wall across
  world.paths = {{"path", {{{1.5, 1.5}}, {{1.5, 3.5}}}}};
  EXPECT_EQ(drawing_of(raster(world, kMetres)),
            "####iiiii\n"
            "#..#    i\n"
            "#..#ii  i\n"
            "#..#ii  i\n"
            "#..#ii  i\n"
            "#..#    i\n"
            "####iiiii\n");
}

TEST(Raster, CutsAtTheHeightThatWasAskedFor) {
  RasterOptions above = kMetres;
  above.height = 1.5;
  EXPECT_EQ(drawing_of(raster(room(), above)),
            "#########\n"
            "#.......#\n"
            "#.......#\n"
            "#.......#\n"
            "#.......#\n"
            "#.......#\n"
            "#########\n");
}

TEST(Raster, DoesNotFillTheCellNextToAWallThatEndsAtItsBorder) {
  World world;
  world.entities = {block(0, 0, 0.15, 1, 0, 1)};
  const TrueMap map = raster(world, {.height = 0.5, .resolution = 0.05, .margin = 0.1});
  int filled = 0;
  for (int x = 0; x < map.width; ++x) filled += map.at(x, map.height / 2) != TrueCell::free;
  EXPECT_EQ(filled, 3);
}

TEST(Raster, DrawsACellIntoWhichOnlyACornerReaches) {
  World world;
  world.entities = {{.name = "leg",
                     .world_from_entity = upright({0.05, 0.05, 0.0}),
                     .parts = {{.name = "leg", .geometry = Cylinder{0.01, 1.0}}}}};
  const TrueMap map = raster(world, {.height = 0.3, .resolution = 0.05, .margin = 0.1});
  const auto filled = std::count(map.entities.begin(), map.entities.end(), 0);
  EXPECT_EQ(filled, 4) << "it stands where four cells meet";
}

TEST(Raster, RefusesAMapThatDoesNotFitIntoMemory) {
  try {
    raster(room(), {.resolution = 1e-5});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("world 'room' is too large for memory: 9 m x 7 m"));
    EXPECT_THAT(error.what(), HasSubstr("take a coarser resolution"));
  }
}

// The walls and the block of the room cover 9 + 9 + 7 + 7 + 9 cells, and have four corners each.
TEST(Raster, RefusesAMapThatTakesTooLong) {
  RasterOptions options = kMetres;
  options.max_looks = 4 * 41 + 1;
  EXPECT_NO_THROW(raster(room(), options));
  options.max_looks = 4 * 41 - 1;
  try {
    raster(room(), options);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("world 'room' has too many or too large things for a map of "
                          "cells of 1 m; take a coarser resolution"));
  }
}

}  // namespace
}  // namespace mapbed
