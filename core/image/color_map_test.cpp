#include "core/image/color_map.h"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

double luminance(const Rgb& color) {  // CIE Y of sRGB
  const auto linear = [](std::uint8_t byte) {
    const double x = byte / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

TEST(ColorMap, GrayGoesFromBlackToWhite) {
  EXPECT_EQ(color_of(ColorMap::gray, 0.0), kBlack);
  EXPECT_EQ(color_of(ColorMap::gray, 1.0), kWhite);
}

TEST(ColorMap, GetsLighterAllTheWayFromBlueToYellow) {
  double last = -1.0;
  for (int i = 0; i <= 100; ++i) {
    const Rgb color = color_of(ColorMap::blue_to_yellow, i / 100.0);
    EXPECT_GT(luminance(color), last) << i;
    last = luminance(color);
  }
  const Rgb low = color_of(ColorMap::blue_to_yellow, 0.0);
  const Rgb high = color_of(ColorMap::blue_to_yellow, 1.0);
  EXPECT_GT(low.blue, low.red);
  EXPECT_GT(high.red, high.blue);
}

TEST(ColorMap, FractionsOutsideTakeTheNearestEnd) {
  const auto map = ColorMap::blue_to_yellow;
  EXPECT_EQ(color_of(map, -3.0), color_of(map, 0.0));
  EXPECT_EQ(color_of(map, 7.0), color_of(map, 1.0));
  EXPECT_EQ(color_of(map, std::numeric_limits<double>::quiet_NaN()), color_of(map, 0.0));
}

TEST(ColorMap, CategoricalColorsDifferAndRepeatAfterEight) {
  std::set<int> seen;
  for (int i = 0; i < 8; ++i) {
    const Rgb color = categorical_color(i);
    seen.insert((color.red * 256 + color.green) * 256 + color.blue);
  }
  EXPECT_EQ(seen.size(), 8u);
  EXPECT_EQ(categorical_color(8), categorical_color(0));
}

}  // namespace
}  // namespace mapbed
