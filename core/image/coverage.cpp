#include "core/image/coverage.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr int kSubRows = 3;  // of a pixel, for polygons

double squared_distance_to_segment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                                   const Eigen::Vector2d& along, double squared_length) {
  const Eigen::Vector2d off = point - from;
  if (squared_length == 0.0) return off.squaredNorm();
  const double fraction = std::clamp(off.dot(along) / squared_length, 0.0, 1.0);
  return (off - fraction * along).squaredNorm();
}

// Where the polygon's border crosses the height y, in order.
void crossings(std::span<const Eigen::Vector2d> corners, double y, std::vector<double>& x) {
  x.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    x.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(x.begin(), x.end());
}

// Adds how much of each pixel of a row lies in [from, to).
void add_span(double from, double to, std::vector<float>& row) {
  from = std::clamp(from, 0.0, static_cast<double>(row.size()));
  to = std::clamp(to, 0.0, static_cast<double>(row.size()));
  for (auto x = static_cast<std::size_t>(from); static_cast<double>(x) < to; ++x) {
    const auto left = static_cast<double>(x);
    row[x] += static_cast<float>(std::min(to, left + 1.0) - std::max(from, left)) / kSubRows;
  }
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, int weight) {  // [0, 256]
  return static_cast<std::uint8_t>((below * (256 - weight) + above * weight + 128) >> 8);
}

}  // namespace

Coverage::Coverage(int width, int height) : mask_(width, height), touched_{width, height, 0, 0} {}

Coverage::Box Coverage::pixels_about(const Eigen::Vector2d& low,
                                     const Eigen::Vector2d& high) const {
  const auto within = [](double value, int most) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(most)));
  };
  return {within(low.x(), mask_.width()), within(low.y(), mask_.height()),
          within(high.x() + 1.0, mask_.width()), within(high.y() + 1.0, mask_.height())};
}

void Coverage::touch(const Box& box) {
  touched_ = {std::min(touched_.left, box.left), std::min(touched_.top, box.top),
              std::max(touched_.right, box.right), std::max(touched_.bottom, box.bottom)};
}

void Coverage::raise(int x, int y, double coverage) {
  std::uint8_t& pixel = mask_.at(x, y);
  pixel = std::max(pixel, static_cast<std::uint8_t>(std::lround(255.0 * coverage)));
}

void Coverage::add_segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width) {
  const double reach = 0.5 * width + 0.5;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(reach);
  const Box box = pixels_about(from.cwiseMin(to) - margin, from.cwiseMax(to) + margin);
  const Eigen::Vector2d along = to - from;
  const double squared_length = along.squaredNorm();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double off =
          squared_distance_to_segment({x + 0.5, y + 0.5}, from, along, squared_length);
      if (off < reach * reach) raise(x, y, std::min({reach - std::sqrt(off), width, 1.0}));
    }
  }
  touch(box);
}

void Coverage::add_stroke(std::span<const Eigen::Vector2d> points, double width) {
  const Eigen::Vector2d* last = nullptr;
  for (const Eigen::Vector2d& point : points) {
    if (!point.allFinite()) {
      last = nullptr;
      continue;
    }
    // Joints that cannot be told apart cost time alone.
    if (last != nullptr && &point != &points.back() && (point - *last).squaredNorm() < 0.25) {
      continue;
    }
    add_segment(last == nullptr ? point : *last, point, width);
    last = &point;
  }
}

void Coverage::add_disc(const Eigen::Vector2d& center, double radius) {
  if (center.allFinite()) add_segment(center, center, 2.0 * radius);
}

void Coverage::add_polygon(std::span<const Eigen::Vector2d> corners) {
  if (corners.size() < 3) return;
  Eigen::Vector2d low = corners.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& corner : corners) {
    if (!corner.allFinite()) return;
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Box box = pixels_about(low, high);
  std::vector<double> x;
  std::vector<float> row(static_cast<std::size_t>(mask_.width()));
  for (int y = box.top; y < box.bottom; ++y) {
    std::fill(row.begin(), row.end(), 0.0F);
    for (int sub = 0; sub < kSubRows; ++sub) {
      crossings(corners, y + (sub + 0.5) / kSubRows, x);
      for (std::size_t i = 0; i + 1 < x.size(); i += 2) add_span(x[i], x[i + 1], row);
    }
    for (int at = box.left; at < box.right; ++at) {
      const float covered = row[static_cast<std::size_t>(at)];
      if (covered > 0.0F) raise(at, y, std::min(covered, 1.0F));
    }
  }
  touch(box);
}

void Coverage::blend_into(RgbImage& image, const Rgb& color, double opacity) {
  CHECK(image.width() == mask_.width() && image.height() == mask_.height());
  const int strength = static_cast<int>(std::lround(256.0 * std::clamp(opacity, 0.0, 1.0)));
  for (int y = touched_.top; y < touched_.bottom; ++y) {
    for (int x = touched_.left; x < touched_.right; ++x) {
      std::uint8_t& covered = mask_.at(x, y);
      if (covered == 0) continue;
      const int weight = covered * strength / 255;
      Rgb& pixel = image.at(x, y);
      pixel = {mixed(pixel.red, color.red, weight), mixed(pixel.green, color.green, weight),
               mixed(pixel.blue, color.blue, weight)};
      covered = 0;
    }
  }
  touched_ = {mask_.width(), mask_.height(), 0, 0};
}

}  // namespace mapbed
