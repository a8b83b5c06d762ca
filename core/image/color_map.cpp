#include "core/image/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapbed {
namespace {

// Ottosson's Oklab: lightness, green to red, blue to yellow.
struct Oklab {
  double lightness, a, b;
};

constexpr Oklab kDarkBlue{0.25, -0.01, -0.13};
constexpr Oklab kLightYellow{0.93, -0.01, 0.17};

std::uint8_t srgb_byte(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

Rgb srgb(const Oklab& color) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(color.lightness + 0.3963377774 * color.a + 0.2158037573 * color.b);
  const double m = cube(color.lightness - 0.1055613458 * color.a - 0.0638541728 * color.b);
  const double s = cube(color.lightness - 0.0894841775 * color.a - 1.2914855480 * color.b);
  return {srgb_byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          srgb_byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          srgb_byte(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Rgb color_of(ColorMap map, double fraction) {
  const double t = fraction > 0.0 ? std::min(fraction, 1.0) : 0.0;  // NaN is not > 0
  if (map == ColorMap::gray) {
    const auto level = static_cast<std::uint8_t>(std::lround(255.0 * t));
    return {level, level, level};
  }
  return srgb({std::lerp(kDarkBlue.lightness, kLightYellow.lightness, t),
               std::lerp(kDarkBlue.a, kLightYellow.a, t),
               std::lerp(kDarkBlue.b, kLightYellow.b, t)});
}

Rgb categorical_color(int index) {
  CHECK(index >= 0);
  constexpr std::array<Rgb, 8> kColors = {{{0, 0, 0},          // black
                                           {230, 159, 0},      // orange
                                           {86, 180, 233},     // sky blue
                                           {0, 158, 115},      // bluish green
                                           {240, 228, 66},     // yellow
                                           {0, 114, 178},      // blue
                                           {213, 94, 0},       // vermilion
                                           {204, 121, 167}}};  // reddish purple
  return kColors[static_cast<std::size_t>(index) % kColors.size()];
}

}  // namespace mapbed
