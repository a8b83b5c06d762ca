#include "bench/figures/range_profile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "bench/figures/plane_panel.h"
#include "core/geometry/angle.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kLeft = 46.0, kBelow = 40.0, kAbove = 12.0, kRight = 14.0;  // [pixels]
constexpr double kFarthest = 15.0;                                           // [m] that is shown
constexpr double kTextSize = 13.0;
constexpr Rgb kGrid{225, 225, 225};

// From bearing [rad] and range [m] to the picture, bearings to the left first as they are seen.
struct Axes {
  double first, last;  // [rad]
  double farthest;     // [m]
  int width, height;   // [pixels] of the picture

  Eigen::Vector2d pixel_of(double bearing, double range) const {
    const double x = (last - bearing) / (last - first);
    return {kLeft + x * (width - kLeft - kRight),
            height - kBelow - range / farthest * (height - kBelow - kAbove)};
  }
};

void draw_axes(RgbImage& image, const Axes& axes) {
  const Pen pen{.color = kGrid, .width = 1.0};
  for (double range = 0.0; range <= axes.farthest; range += 2.0) {
    const Eigen::Vector2d left = axes.pixel_of(axes.last, range);
    draw_line(image, left, axes.pixel_of(axes.first, range), pen);
    const std::string text = fmt::format("{:g}", range);
    draw_text(image, {left.x() - text_width(text, kTextSize) - 6.0, left.y() + 4.0}, text,
              {.size = kTextSize});
  }
  const double step = degrees(axes.last - axes.first) > 200.0 ? 45.0 : 30.0;
  for (double angle = step * std::ceil(degrees(axes.first) / step); angle <= degrees(axes.last);
       angle += step) {
    const Eigen::Vector2d foot = axes.pixel_of(radians(angle), 0.0);
    draw_line(image, foot, axes.pixel_of(radians(angle), axes.farthest), pen);
    const std::string text = fmt::format("{:g}°", angle);
    draw_text(image, {foot.x() - 0.5 * text_width(text, kTextSize), foot.y() + 16.0}, text,
              {.size = kTextSize});
  }
  draw_text(image, {kLeft, axes.height - 6.0}, "range [m] over bearing", {.size = kTextSize});
}

}  // namespace

RgbImage range_profile(const ScanView& view, const std::vector<LegFeature>& features, int width,
                       int height, const Rgb& mark) {
  RgbImage image(width, height, kWhite);
  if (view.eyes().empty()) return image;
  const LaserScan& scan = view.scan();
  Axes axes{HUGE_VAL, -HUGE_VAL, 2.0, width, height};
  for (const ScanView::Eye& eye : view.eyes()) {
    axes.first = std::min(axes.first, eye.bearings.front() - eye.step);
    axes.last = std::max(axes.last, eye.bearings.back() + eye.step);
  }
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (scan.is_hit(beam)) axes.farthest = std::max(axes.farthest, scan.ranges[beam] + 0.5);
  }
  axes.farthest = std::min(axes.farthest, kFarthest);
  draw_axes(image, axes);
  std::vector<bool> is_marked(scan.ranges.size(), false);
  for (const LegFeature& feature : features) {
    std::fill(is_marked.begin() + static_cast<std::ptrdiff_t>(feature.first),
              is_marked.begin() + static_cast<std::ptrdiff_t>(feature.last) + 1, true);
  }
  for (const ScanView::Eye& eye : view.eyes()) {
    for (std::size_t i = 0; i < eye.size(); ++i) {
      const std::size_t beam = eye.beam(i);
      if (!scan.is_hit(beam) || scan.ranges[beam] > axes.farthest) continue;
      const Eigen::Vector2d place = axes.pixel_of(eye.bearings[i], scan.ranges[beam]);
      fill_disc(image, place, is_marked[beam] ? 3.2 : 1.6, is_marked[beam] ? mark : kScanColor);
    }
  }
  return image;
}

}  // namespace mapbed
