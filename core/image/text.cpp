#include "core/image/text.h"

#include <algorithm>
#include <cmath>

#include "core/image/draw.h"
#include "core/image/stroke_font.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

constexpr double kCapitalHeight = 0.7;  // of the size
constexpr double kStrokeWidth = 0.09;   // of the size

// Pixels for one unit of the font: small letters, 6 units, are a whole number of pixels high, so
// that base line and top of the letters are sharp.
double unit_of(double size) {
  return std::max(1.0, std::round(6.0 * kCapitalHeight * size / 9.0)) / 6.0;
}

double advance_of(const Glyph& glyph, double unit) {
  return std::round(glyph.advance * unit);
}

}  // namespace

double text_width(std::string_view text, double size) {
  CHECK(std::isfinite(size) && size > 0.0);
  double width = 0.0;
  while (!text.empty()) width += advance_of(next_glyph(text), unit_of(size));
  return width;
}

void draw_text(RgbImage& image, const Vector2d& start, std::string_view text,
               const TextStyle& style) {
  CHECK(std::isfinite(style.size) && style.size > 0.0);
  const double unit = unit_of(style.size);
  std::vector<std::vector<Vector2d>> strokes;
  Vector2d origin = start.array().floor() + 0.5;  // a pixel's centre
  while (!text.empty()) {
    const Glyph glyph = next_glyph(text);
    for (std::vector<Vector2d> stroke : glyph.strokes) {
      for (Vector2d& point : stroke) point = origin + unit * Vector2d(point.x(), -point.y());
      strokes.push_back(std::move(stroke));
    }
    origin.x() += advance_of(glyph, unit);
  }
  const double width = std::max(1.0, kStrokeWidth * style.size);
  if (style.halo > 0.0) draw_polylines(image, strokes, {kWhite, width + 2.0 * style.halo, 0.8});
  draw_polylines(image, strokes, {style.color, width});
}

}  // namespace mapbed
