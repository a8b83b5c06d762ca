#include "core/image/draw.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

const RgbImage kPaper(40, 40, kWhite);

// Covered area in pixels: how much black there is.
double ink(const RgbImage& image) {
  double sum = 0.0;
  for (const Rgb& pixel : image.pixels()) sum += (255.0 - pixel.red) / 255.0;
  return sum;
}

std::string drawing_of(const RgbImage& image) {
  std::string text;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const int level = image.at(x, y).red;
      text += level < 64 ? '#' : level < 192 ? '+' : '.';
    }
    text += '\n';
  }
  return text;
}

TEST(Draw, ALineThroughPixelCentresFillsThesePixels) {
  RgbImage image(5, 3, kWhite);
  draw_line(image, {0.5, 1.5}, {4.5, 1.5}, {});
  EXPECT_EQ(drawing_of(image), ".....\n#####\n.....\n");
}

TEST(Draw, ALineBetweenTwoRowsDarkensBothByHalf) {
  RgbImage image(5, 4, kWhite);
  draw_line(image, {-3.0, 2.0}, {8.0, 2.0}, {});
  EXPECT_EQ(drawing_of(image), ".....\n+++++\n+++++\n.....\n");
}

TEST(Draw, ALineIsAsBroadInEveryDirection) {
  for (int degree = 0; degree < 180; degree += 15) {
    RgbImage image = kPaper;
    const Vector2d half = 12.0 * Vector2d(std::cos(radians(degree)), std::sin(radians(degree)));
    const Vector2d center(20.2, 19.7);
    draw_line(image, center - half, center + half, {.width = 3.0});
    const double area = 24.0 * 3.0 + kPi * 1.5 * 1.5;      // body and the half discs at both ends
    EXPECT_NEAR(ink(image), area, 0.03 * area) << degree;  // edges are linear, not exact
  }
}

TEST(Draw, APathIsNoDarkerWhereItMeetsItself) {
  RgbImage image = kPaper;
  draw_polyline(image, {{5, 20}, {35, 20}, {5, 20}, {20, 5}, {20, 35}},
                {.width = 5, .opacity = 0.5});
  EXPECT_EQ(image.at(20, 20), image.at(30, 20));
  EXPECT_EQ(image.at(30, 20), (Rgb{128, 128, 128}));
}

TEST(Draw, APointThatIsNotFiniteInterruptsThePath) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RgbImage broken = kPaper, apart = kPaper;
  draw_polyline(broken, {{nan, 0}, {5, 5}, {15, 5}, {nan, 5}, {25, 5}, {35, 5}}, {});
  draw_line(apart, {5, 5}, {15, 5}, {});
  draw_line(apart, {25, 5}, {35, 5}, {});
  EXPECT_EQ(broken, apart);
  draw_polyline(apart, {{nan, nan}}, {});
  EXPECT_EQ(broken, apart);
}

TEST(Draw, WhatLiesOutsideIsCutOff) {
  RgbImage image = kPaper;
  draw_line(image, {-1e9, 20.5}, {1e9, 20.5}, {});
  EXPECT_NEAR(ink(image), 40.0, 0.5);
  RgbImage far = kPaper;
  draw_line(far, {100, 100}, {1e300, 1e300}, {});
  fill_disc(far, {-50, 20}, 10, kBlack);
  fill_rectangle(far, {50, 0}, {60, 10}, kBlack);
  EXPECT_EQ(far, kPaper);
  RgbImage nothing;
  draw_line(nothing, {0, 0}, {5, 5}, {});
}

TEST(Draw, DiscsCirclesAndRectanglesCoverTheirArea) {
  RgbImage disc = kPaper, circle = kPaper, rectangle = kPaper;
  fill_disc(disc, {20.3, 19.8}, 8.0, kBlack);
  EXPECT_NEAR(ink(disc), kPi * 64.0, 2.0);
  draw_circle(circle, {20.3, 19.8}, 8.0, {.width = 2.0});
  EXPECT_NEAR(ink(circle), kPi * (81.0 - 49.0), 2.0);
  fill_rectangle(rectangle, {10.25, 10.5}, {30.0, 12.0}, kBlack);
  EXPECT_NEAR(ink(rectangle), 19.75 * 1.5, 0.2);  // rounding of 20 edge pixels
}

TEST(Draw, OpacityMixesColors) {
  RgbImage image(1, 1, {100, 100, 100});
  blend(image, 0, 0, {200, 0, 100}, 0.25);
  EXPECT_EQ(image.at(0, 0), (Rgb{125, 75, 100}));
  blend(image, 0, 0, kBlack, -1.0);
  blend(image, 5, 5, kBlack, 1.0);
  EXPECT_EQ(image.at(0, 0), (Rgb{125, 75, 100}));
  blend(image, 0, 0, kBlack, 7.0);
  EXPECT_EQ(image.at(0, 0), kBlack);
}

}  // namespace
}  // namespace mapbed
