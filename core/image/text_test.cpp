#include "core/image/text.h"

#include <string>

#include <gtest/gtest.h>

#include "core/image/stroke_font.h"

namespace mapbed {
namespace {

std::string drawing_of(const RgbImage& image) {
  std::string text;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) text += image.at(x, y).red < 128 ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(Text, IsReadable) {
  RgbImage image(14, 12, kWhite);
  draw_text(image, {1.2, 10.4}, "TL", {.size = 13.0});  // one pixel for each unit of the font
  EXPECT_EQ(drawing_of(image),
            "..............\n"
            ".#######..#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....#...\n"
            "....#.....####\n"
            "..............\n");
}

TEST(Text, EverySignOfAsciiHasItsOwnShape) {
  std::string box = "\u20ac";
  std::string_view unknown = box;
  const Glyph none = next_glyph(unknown);
  for (char c = '!'; c <= '~'; ++c) {
    const std::string sign(1, c);
    std::string_view text = sign;
    const Glyph glyph = next_glyph(text);
    EXPECT_TRUE(text.empty());
    EXPECT_FALSE(glyph.strokes.empty()) << c;
    EXPECT_NE(glyph.strokes, none.strokes) << c;
    for (const auto& stroke : glyph.strokes) {
      for (const Eigen::Vector2d& point : stroke) {
        EXPECT_TRUE(point.x() >= 0.0 && point.x() < glyph.advance) << c;
        EXPECT_TRUE(point.y() >= -3.0 && point.y() <= 11.0) << c;
      }
    }
  }
}

TEST(Text, AnUnknownSignIsOneBox) {
  EXPECT_EQ(text_width("\u20ac", 13.0), text_width("\U0001F600", 13.0));
  std::string_view text = "\u20ac\u00b0x";
  next_glyph(text);
  EXPECT_EQ(text, "\u00b0x");
  next_glyph(text);
  EXPECT_EQ(text, "x");
}

TEST(Text, WidthsAddUpAndDigitsStandInColumns) {
  EXPECT_EQ(text_width("", 12.0), 0.0);
  EXPECT_EQ(text_width("ab", 12.0), text_width("a", 12.0) + text_width("b", 12.0));
  EXPECT_EQ(text_width("1111", 14.0), text_width("8080", 14.0));
}

TEST(Text, AHaloSetsItOffFromADarkMap) {
  RgbImage image(20, 20, {60, 60, 60});
  draw_text(image, {8, 15}, "l", {.size = 13.0, .halo = 2.0});
  EXPECT_LT(image.at(8, 10).red, 60);
  EXPECT_GT(image.at(6, 10).red, 150);
  EXPECT_EQ(image.at(1, 10).red, 60);
}

}  // namespace
}  // namespace mapbed
