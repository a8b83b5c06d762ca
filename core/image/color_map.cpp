#include "core/image/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mapbed {
namespace {

std::array<Rgb, 256> cividis() {
  cv::Mat levels(1, 256, CV_8U);
  for (int level = 0; level < 256; ++level) {
    levels.at<std::uint8_t>(0, level) = static_cast<std::uint8_t>(level);
  }
  cv::Mat colors;  // blue, green, red
  cv::applyColorMap(levels, colors, cv::COLORMAP_CIVIDIS);
  std::array<Rgb, 256> table;
  std::transform(colors.begin<cv::Vec3b>(), colors.end<cv::Vec3b>(), table.begin(),
                 [](const cv::Vec3b& c) {
                   return Rgb{c[2], c[1], c[0]};
                 });
  return table;
}

}  // namespace

Rgb color_of(ColorMap map, double share) {
  const double t = share > 0.0 ? std::min(share, 1.0) : 0.0;  // NaN is not > 0
  const auto level = static_cast<std::uint8_t>(std::lround(255.0 * t));
  if (map == ColorMap::gray) return {level, level, level};
  static const std::array<Rgb, 256> kCividis = cividis();
  return kCividis[level];
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
