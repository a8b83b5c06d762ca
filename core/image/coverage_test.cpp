#include "core/image/coverage.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

using Eigen::Vector2d;

// Of a white picture on which black was painted: how much of each pixel is covered, all together.
double covered_area(const RgbImage& image) {
  double area = 0.0;
  for (const Rgb& pixel : image.pixels()) area += (255.0 - pixel.red) / 255.0;
  return area;
}

TEST(Coverage, ADiscHasTheAreaOfACircle) {
  RgbImage image(40, 40, kWhite);
  Coverage coverage(40, 40);
  coverage.add_disc({20.3, 19.6}, 10.0);
  coverage.blend_into(image, kBlack);
  EXPECT_NEAR(covered_area(image), M_PI * 100.0, 0.01 * M_PI * 100.0);
}

TEST(Coverage, APolygonCoversPartsOfThePixelsAtItsBorder) {
  RgbImage image(4, 3, kWhite);
  Coverage coverage(4, 3);
  const std::vector<Vector2d> corners{{1.5, 1.0}, {3.0, 1.0}, {3.0, 2.0}, {1.5, 2.0}};
  coverage.add_polygon(corners);
  coverage.blend_into(image, kBlack);
  EXPECT_EQ(image.at(0, 1), kWhite);
  EXPECT_NEAR(image.at(1, 1).red, 127.5, 1.0) << "half of it";
  EXPECT_EQ(image.at(2, 1), kBlack);
  EXPECT_EQ(image.at(3, 1), kWhite);
  EXPECT_EQ(image.at(2, 0), kWhite);
  EXPECT_EQ(image.at(2, 2), kWhite);
}

TEST(Coverage, AStrokeIsNoDarkerWhereItCrossesItself) {
  RgbImage image(20, 20, kWhite);
  Coverage coverage(20, 20);
  const std::vector<Vector2d> cross{{2, 10.5}, {18, 10.5}, {18, 2}, {10.5, 2}, {10.5, 18}};
  coverage.add_stroke(cross, 0.5);  // half of each pixel's height
  coverage.blend_into(image, kBlack);
  EXPECT_EQ(image.at(10, 10), image.at(5, 10));
  EXPECT_NEAR(image.at(5, 10).red, 127.5, 1.0);
}

TEST(Coverage, WhatLiesOutsideOrIsNoNumberIsLeftOut) {
  RgbImage image(5, 5, kWhite);
  Coverage coverage(5, 5);
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vector2d> stroke{{-50, -50}, {-40, 1e12}, {none, 2.0}, {300, 4}};
  coverage.add_stroke(stroke, 2.0);
  const std::vector<Vector2d> triangle{{0, 0}, {5, 0}, {none, 5}};
  coverage.add_polygon(triangle);
  coverage.add_disc({none, none}, 3.0);
  coverage.blend_into(image, kBlack);
  EXPECT_EQ(covered_area(image), 0.0);
}

TEST(Coverage, NothingIsCoveredAfterBlending) {
  RgbImage image(8, 8, kWhite);
  Coverage coverage(8, 8);
  coverage.add_disc({4, 4}, 3.0);
  coverage.blend_into(image, kBlack);
  RgbImage next(8, 8, kWhite);
  coverage.add_stroke(std::vector<Vector2d>{{0.0, 0.0}, {8.0, 8.0}}, 0.5);
  coverage.blend_into(next, kBlack);
  EXPECT_EQ(next.at(5, 2), kWhite) << "within the disc, and far from the stroke";
}

}  // namespace
}  // namespace mapbed
