#include "bench/film/growing_map.h"

#include <gtest/gtest.h>

#include "bench/plot/map_raster.h"

namespace mapbed {
namespace {

// One beam straight ahead that hits something after 2 m.
LaserScan beam_of_two_meters() {
  return {.bearing_step = 0.1, .max_range = 10.0, .ranges = {2.0}};
}

// Cells of 1 m, the robot in the middle of the left one.
class GrowingMapOf : public ::testing::Test {
 protected:
  GrowingMapOf() : map_({.resolution = 1.0, .origin = {-0.5, -0.5}}, 5, 3) {}

  std::string row(int y) {
    const RgbImage& picture = map_.picture();
    std::string text;
    for (int x = 0; x < picture.width(); ++x) {
      const Rgb& pixel = picture.at(x, picture.height() - 1 - y);
      text += pixel == kWhite ? '.' : pixel == kBlack ? '#' : pixel == kUnknownColor ? ' ' : '?';
    }
    return text;
  }
  GrowingMap map_;
};

TEST_F(GrowingMapOf, AScanClearsItsWayAndFillsItsEnd) {
  map_.put(0, beam_of_two_meters(), {0.0, 1.0, 0.0});
  EXPECT_EQ(row(0), "     ");
  EXPECT_EQ(row(1), "..#  ");
}

TEST_F(GrowingMapOf, AScanThatIsMovedLeavesNothingBehind) {
  map_.put(0, beam_of_two_meters(), {0.0, 1.0, 0.0});
  EXPECT_EQ(row(1), "..#  ") << "looked at in between";
  map_.put(0, beam_of_two_meters(), {2.0, 0.0, 0.0});
  EXPECT_EQ(row(1), "     ");
  EXPECT_EQ(row(0), "  ..#");
}

TEST_F(GrowingMapOf, AnotherScanThatWasThereStays) {
  map_.put(0, beam_of_two_meters(), {0.0, 1.0, 0.0});
  map_.put(1, beam_of_two_meters(), {0.0, 1.0, 0.0});
  map_.put(0, beam_of_two_meters(), {0.0, 0.0, 0.0});
  EXPECT_EQ(row(1), "..#  ");
  EXPECT_EQ(row(0), "..#  ");
}

TEST_F(GrowingMapOf, ADynamicBeamClearsItsWayAndLeavesNothingAtItsEnd) {
  const ScanLabels labels{.static_probability = {0.2F}};
  map_.put(0, beam_of_two_meters(), {0.0, 1.0, 0.0}, &labels);
  EXPECT_EQ(row(1), "..   ");
  map_.put(0, beam_of_two_meters(), {2.0, 0.0, 0.0}, &labels);
  EXPECT_EQ(row(1), "     ") << "it was moved";
  EXPECT_EQ(row(0), "  .. ");
}

TEST_F(GrowingMapOf, WhatLiesOutsideIsLeftOut) {
  map_.put(0, beam_of_two_meters(), {4.0, 1.0, 0.0});
  map_.put(1, beam_of_two_meters(), {0.0, 50.0, 0.0});
  EXPECT_EQ(row(1), "    .");
}

}  // namespace
}  // namespace mapbed
