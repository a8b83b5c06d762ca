#include "core/image/draw.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace mapbed {

namespace {

using Eigen::Vector2d;

// Pixels whose centres may lie within [low, high], cut to [0, size).
struct Range {
  int first;
  int end;
};
Range pixels_within(double low, double high, int size) {
  const double first = std::clamp(std::floor(low), 0.0, static_cast<double>(size));
  const double end = std::clamp(std::ceil(high), first, static_cast<double>(size));
  return {static_cast<int>(first), static_cast<int>(end)};
}

// How much of a pixel lies inside an edge that runs `inside` pixels from its centre.
double coverage_of(double inside) {
  return std::clamp(inside + 0.5, 0.0, 1.0);
}

// What a pen has touched of a part of the picture, blended in once in the end.
class Mask {
 public:
  Mask(Range x, Range y)
      : x_(x),
        y_(y),
        coverage_(static_cast<std::size_t>(x.end - x.first) *
                  static_cast<std::size_t>(y.end - y.first)) {}

  void add_segment(const Vector2d& a, const Vector2d& b, double radius) {
    const double reach = radius + 1.0;
    const Vector2d along = b - a;
    const double length2 = along.squaredNorm();
    const Range rows =
        pixels_within(std::min(a.y(), b.y()) - reach, std::max(a.y(), b.y()) + reach, y_.end);
    for (int y = std::max(rows.first, y_.first); y < rows.end; ++y) {
      // the part of the segment that comes near this row
      double t0 = 0.0, t1 = 1.0;
      if (std::abs(along.y()) > 1e-9) {
        const double ta = (y + 0.5 - reach - a.y()) / along.y();
        const double tb = (y + 0.5 + reach - a.y()) / along.y();
        t0 = std::clamp(std::min(ta, tb), 0.0, 1.0);
        t1 = std::clamp(std::max(ta, tb), 0.0, 1.0);
      }
      const double x0 = a.x() + t0 * along.x();
      const double x1 = a.x() + t1 * along.x();
      const Range columns =
          pixels_within(std::min(x0, x1) - reach, std::max(x0, x1) + reach, x_.end);
      for (int x = std::max(columns.first, x_.first); x < columns.end; ++x) {
        const Vector2d center(x + 0.5, y + 0.5);
        const double t =
            length2 > 0.0 ? std::clamp((center - a).dot(along) / length2, 0.0, 1.0) : 0.0;
        add(x, y, coverage_of(radius - (center - a - t * along).norm()));
      }
    }
  }

  void blend_into(RgbImage& image, const Rgb& color, double opacity) const {
    for (int y = y_.first; y < y_.end; ++y) {
      for (int x = x_.first; x < x_.end; ++x) {
        const double covered = coverage_[index(x, y)] / 255.0;
        if (covered > 0.0) blend(image, x, y, color, covered * opacity);
      }
    }
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y_.first) * static_cast<std::size_t>(x_.end - x_.first) +
           static_cast<std::size_t>(x - x_.first);
  }
  void add(int x, int y, double covered) {
    std::uint8_t& old = coverage_[index(x, y)];
    old = std::max(old, static_cast<std::uint8_t>(std::lround(255.0 * covered)));
  }

  Range x_, y_;
  std::vector<std::uint8_t> coverage_;  // 255: the whole pixel
};

// Blends a shape, given by the coverage of the pixel around each point, within a box.
template <class Coverage>
void fill(RgbImage& image, const Vector2d& low, const Vector2d& high, const Rgb& color,
          double opacity, const Coverage& coverage) {
  if (!low.allFinite() || !high.allFinite()) return;
  const Range rows = pixels_within(low.y(), high.y(), image.height());
  const Range columns = pixels_within(low.x(), high.x(), image.width());
  for (int y = rows.first; y < rows.end; ++y) {
    for (int x = columns.first; x < columns.end; ++x) {
      blend(image, x, y, color, opacity * coverage(Vector2d(x + 0.5, y + 0.5)));
    }
  }
}

// How much of [low, low + 1] lies within [from, to].
double overlap(double low, double from, double to) {
  return std::max(0.0, std::min(low + 1.0, to) - std::max(low, from));
}

}  // namespace

void blend(RgbImage& image, int x, int y, const Rgb& color, double opacity) {
  if (!image.contains(x, y) || !(opacity > 0.0)) return;
  const double share = std::min(opacity, 1.0);
  const auto mixed = [&](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>(std::lround(below + share * (above - below)));
  };
  Rgb& pixel = image.at(x, y);
  pixel = {mixed(pixel.red, color.red), mixed(pixel.green, color.green),
           mixed(pixel.blue, color.blue)};
}

void draw_line(RgbImage& image, const Vector2d& from, const Vector2d& to, const Pen& pen) {
  draw_polyline(image, {from, to}, pen);
}

void draw_polyline(RgbImage& image, const std::vector<Vector2d>& points, const Pen& pen) {
  draw_polylines(image, {points}, pen);
}

void draw_polylines(RgbImage& image, const std::vector<std::vector<Vector2d>>& paths,
                    const Pen& pen) {
  Eigen::AlignedBox2d box;
  for (const auto& path : paths) {
    for (const Vector2d& point : path) {
      if (point.allFinite()) box.extend(point);
    }
  }
  if (box.isEmpty()) return;
  const double radius = 0.5 * pen.width;
  const double reach = radius + 1.0;
  Mask mask(pixels_within(box.min().x() - reach, box.max().x() + reach, image.width()),
            pixels_within(box.min().y() - reach, box.max().y() + reach, image.height()));
  for (const auto& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Vector2d& from = path[i > 0 && path[i - 1].allFinite() ? i - 1 : i];
      if (path[i].allFinite()) mask.add_segment(from, path[i], radius);
    }
  }
  mask.blend_into(image, pen.color, pen.opacity);
}

void fill_disc(RgbImage& image, const Vector2d& center, double radius, const Rgb& color,
               double opacity) {
  const Vector2d reach = Vector2d::Constant(radius + 1.0);
  fill(image, center - reach, center + reach, color, opacity,
       [&](const Vector2d& p) { return coverage_of(radius - (p - center).norm()); });
}

void draw_circle(RgbImage& image, const Vector2d& center, double radius, const Pen& pen) {
  const Vector2d reach = Vector2d::Constant(radius + 0.5 * pen.width + 1.0);
  fill(image, center - reach, center + reach, pen.color, pen.opacity, [&](const Vector2d& p) {
    return coverage_of(0.5 * pen.width - std::abs(radius - (p - center).norm()));
  });
}

void fill_rectangle(RgbImage& image, const Vector2d& corner, const Vector2d& opposite,
                    const Rgb& color, double opacity) {
  const Vector2d low = corner.cwiseMin(opposite);
  const Vector2d high = corner.cwiseMax(opposite);
  fill(image, low, high, color, opacity, [&](const Vector2d& p) {
    return overlap(p.x() - 0.5, low.x(), high.x()) * overlap(p.y() - 0.5, low.y(), high.y());
  });
}

}  // namespace mapbed
