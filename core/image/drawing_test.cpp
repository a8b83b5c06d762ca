#include "core/image/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

TEST(Drawing, ALineThroughPixelCentresFillsThesePixels) {
  RgbImage image(5, 3, kWhite);
  draw_line(image, {0.5, 1.5}, {4.5, 1.5}, {});
  EXPECT_EQ(drawing_of(image), ".....\n#####\n.....\n");
}

TEST(Drawing, ALineBetweenTwoRowsDarkensBothByHalf) {
  RgbImage image(5, 4, kWhite);
  draw_line(image, {-3.0, 2.0}, {8.0, 2.0}, {});
  EXPECT_EQ(drawing_of(image), ".....\n+++++\n+++++\n.....\n");
}

TEST(Drawing, ALineIsAsBroadAsItsPenInEveryDirection) {
  for (int degree = 0; degree < 180; degree += 15) {
    for (const double width : {1.0, 1.8, 3.0, 4.2}) {
      RgbImage image = kPaper;
      const Vector2d half = 12.0 * Vector2d(std::cos(radians(degree)), std::sin(radians(degree)));
      const Vector2d center(20.2, 19.7);
      draw_line(image, center - half, center + half, {.width = width});
      const double round_ends = kPi * width * width / 4.0;
      EXPECT_NEAR(ink(image), 24.0 * width + round_ends, 24.0 * 0.2) << degree << ", " << width;
    }
  }
}

TEST(Drawing, APathIsNoDarkerWhereItMeetsItself) {
  RgbImage image = kPaper;
  draw_polyline(image, {{5, 20}, {35, 20}, {5, 20}, {20, 5}, {20, 35}},
                {.width = 5, .opacity = 0.5});
  EXPECT_EQ(image.at(20, 20), image.at(30, 20));
  EXPECT_EQ(image.at(30, 20), (Rgb{128, 128, 128}));
}

TEST(Drawing, APointThatIsNotFiniteInterruptsThePath) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RgbImage broken = kPaper, apart = kPaper;
  draw_polyline(broken, {{nan, 0}, {5, 5}, {15, 5}, {nan, 5}, {25, 5}, {35, 5}}, {});
  draw_line(apart, {5, 5}, {15, 5}, {});
  draw_line(apart, {25, 5}, {35, 5}, {});
  EXPECT_EQ(broken, apart);
  draw_polyline(apart, {{nan, nan}}, {});
  EXPECT_EQ(broken, apart);
}

TEST(Drawing, WhatLiesOutsideIsCutOff) {
  RgbImage image = kPaper;
  draw_line(image, {-1e9, 20.5}, {1e9, 20.5}, {});
  EXPECT_NEAR(ink(image), 40.0, 40.0 * 0.2);
  RgbImage far = kPaper;
  draw_line(far, {100, 100}, {1e300, 1e300}, {});
  fill_disc(far, {-50, 20}, 10, kBlack);
  fill_rectangle(far, {50, 0}, {60, 10}, kBlack);
  EXPECT_EQ(far, kPaper);
  RgbImage nothing;
  draw_line(nothing, {0, 0}, {5, 5}, {});
}

TEST(Drawing, DiscsAndRectanglesCoverTheirArea) {
  RgbImage disc = kPaper, rectangle = kPaper;
  fill_disc(disc, {20.3, 19.8}, 8.0, kBlack);
  EXPECT_NEAR(ink(disc), kPi * 64.0, 0.1 * 2.0 * kPi * 8.0);  // a tenth of a pixel all round
  fill_rectangle(rectangle, {10.0, 10.0}, {30.0, 12.0}, kBlack);
  EXPECT_EQ(ink(rectangle), 40.0);
  fill_rectangle(rectangle, {10.25, 20.5}, {30.0, 22.0}, kBlack);
  EXPECT_NEAR(ink(rectangle), 40.0 + 19.75 * 1.5, 0.1 * 2.0 * (19.75 + 1.5));
}

TEST(Drawing, OpacityMixesColors) {
  RgbImage image(1, 1, {100, 100, 100});
  fill_rectangle(image, {0, 0}, {1, 1}, {200, 0, 100}, 0.25);
  EXPECT_EQ(image.at(0, 0), (Rgb{125, 75, 100}));
  fill_rectangle(image, {0, 0}, {1, 1}, kBlack, -1.0);
  EXPECT_EQ(image.at(0, 0), (Rgb{125, 75, 100}));
  fill_rectangle(image, {0, 0}, {1, 1}, kBlack, 7.0);
  EXPECT_EQ(image.at(0, 0), kBlack);
}

TEST(Drawing, APictureLooksTheSameWhereverItsRowsAreCut) {
  RgbImage image(20, 300, kWhite);
  draw_line(image, {10.5, -10}, {10.5, 310}, {.width = 3.0});
  for (int y = 1; y < 300; ++y) ASSERT_EQ(image.at(9, y), image.at(9, 0)) << y;
}

TEST(Drawing, PastedPixelsBecomeSquares) {
  RgbImage small(2, 1, kWhite), image(7, 4, {9, 9, 9});
  small.at(1, 0) = {1, 2, 3};
  paste(small, 2, image, 1, 1);
  EXPECT_EQ(image.at(2, 2), kWhite);
  EXPECT_EQ(image.at(3, 1), (Rgb{1, 2, 3}));
  EXPECT_EQ(image.at(4, 2), (Rgb{1, 2, 3}));
  for (const auto& [x, y] : {std::pair{0, 1}, {5, 2}, {1, 0}, {4, 3}}) {
    EXPECT_EQ(image.at(x, y), (Rgb{9, 9, 9}));
  }
}

// A single sign on a white ground.
RgbImage picture_of(const std::string& sign) {
  RgbImage image(40, 40, kWhite);
  draw_text(image, {5, 25}, sign, {.size = 15.0});
  return image;
}

TEST(Text, StandsOnItsBaseLineWithSharpEdges) {
  RgbImage image(40, 20, kWhite);
  draw_text(image, {3, 15}, "EL", {.size = 15.0});  // 7 pixels a small letter, 10.5 a capital
  int widest = 0;
  for (int x = 0; x < 40; ++x) {
    widest += image.at(x, 15).red < 64;
    EXPECT_GT(image.at(x, 16).red, 200) << "below the base line, " << x;
    EXPECT_EQ(image.at(x, 3).red, 255) << "above the capitals, " << x;
  }
  EXPECT_GE(widest, 10) << "the feet of both letters";
}

TEST(Text, EverySignHasItsOwnShape) {
  const RgbImage box = picture_of("\u20ac");
  std::set<std::vector<std::uint8_t>> shapes;
  const auto expect_new = [&](const std::string& sign) {
    const RgbImage image = picture_of(sign);
    std::vector<std::uint8_t> reds;
    for (const Rgb& pixel : image.pixels()) reds.push_back(pixel.red);
    EXPECT_NE(image, box) << sign;
    EXPECT_GT(ink(image), 1.5) << sign;
    EXPECT_TRUE(shapes.insert(reds).second) << sign;
  };
  for (char c = '!'; c <= '~'; ++c) {
    if (c != 'l') expect_new(std::string(1, c));  // looks like I
  }
  for (const char* sign : {"\u00b0", "\u00b1", "\u00d7", "\u00b2", "\u00b5"}) expect_new(sign);
  EXPECT_EQ(picture_of("\u03bc"), picture_of("\u00b5")) << "both letters mean micro";
}

TEST(Text, AnUnknownSignIsOneBox) {
  EXPECT_EQ(text_width("\u20ac", 13.0), text_width("\U0001F600", 13.0));
  EXPECT_EQ(picture_of("\u20ac"), picture_of("\U0001F600"));
}

TEST(Text, WidthsAddUpAndDigitsStandInColumns) {
  EXPECT_EQ(text_width("", 12.0), 0.0);
  EXPECT_NEAR(text_width("ab \u00b0", 12.0),
              text_width("a", 12.0) + text_width("b", 12.0) + text_width(" ", 12.0) +
                  text_width("\u00b0", 12.0),
              0.2);
  EXPECT_EQ(text_width("1111", 14.0), text_width("8080", 14.0));
}

TEST(Text, AHaloSetsItOffFromADarkMap) {
  RgbImage image(20, 20, {60, 60, 60});
  draw_text(image, {8, 15}, "l", {.size = 13.0, .halo = 2.0});
  int darkest = 255, lightest = 0;
  for (int x = 0; x < 20; ++x) {
    darkest = std::min<int>(darkest, image.at(x, 10).red);
    lightest = std::max<int>(lightest, image.at(x, 10).red);
  }
  EXPECT_LT(darkest, 60);
  EXPECT_GT(lightest, 150);
  EXPECT_EQ(image.at(1, 10).red, 60);
}

}  // namespace
}  // namespace mapbed
