#include "bench/plot/map_legend.h"

#include <cmath>

#include <fmt/format.h>

#include "bench/plot/map_raster.h"
#include "core/image/drawing.h"

namespace mapbed {
namespace {

constexpr double kSample = 28.0;  // [pixels] length of a sample

// The largest of 1, 2, 5, 10, … m that is at most `longest` metres.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= longest) return factor * power;
  }
  return power;
}

std::string length_text(double meters) {
  return meters < 1.0 ? fmt::format("{:g} cm", 100.0 * meters) : fmt::format("{:g} m", meters);
}

double width_of(const LegendItem& item) {
  return kSample + 8 + text_width(item.text, kLegendTextSize) + 26;
}

void draw_item(RgbImage& image, const LegendItem& item, const Eigen::Vector2d& middle_left) {
  const Eigen::Vector2d right = middle_left + Eigen::Vector2d(kSample, 0);
  if (item.kind == LegendItem::Kind::line) {
    draw_line(image, middle_left, right, {.color = item.color, .width = 3.0});
  } else if (item.kind == LegendItem::Kind::disc) {
    fill_disc(image, (middle_left + right) / 2, 5.0, item.color);
  } else {
    const Eigen::Vector2d half(0, 7);
    const Eigen::Vector2d edge(1, 1);
    fill_rectangle(image, middle_left - half, right + half, {120, 120, 120});
    fill_rectangle(image, middle_left - half + edge, right + half - edge, item.color);
  }
  draw_text(image, right + Eigen::Vector2d(8, 5), item.text, {.size = kLegendTextSize});
}

// Where each item of the legend begins, left to right in as many rows as needed.
std::vector<Eigen::Vector2d> places_of(const std::vector<LegendItem>& items, double width) {
  std::vector<Eigen::Vector2d> places;
  double x = 0.0;
  double y = 0.0;
  for (const LegendItem& item : items) {
    if (x > 0.0 && x + width_of(item) > width) {
      x = 0.0;
      y += kLegendRow;
    }
    places.emplace_back(x, y);
    x += width_of(item);
  }
  return places;
}

}  // namespace

std::vector<LegendItem> legend_of_cells() {
  return {{LegendItem::Kind::area, kBlack, "occupied"},
          {LegendItem::Kind::area, kWhite, "free"},
          {LegendItem::Kind::area, kUnknownColor, "unknown"}};
}

int legend_rows(const std::vector<LegendItem>& items, double width) {
  return items.empty() ? 0 : 1 + static_cast<int>(places_of(items, width).back().y()) / kLegendRow;
}

void draw_legend(RgbImage& image, const std::vector<LegendItem>& items,
                 const Eigen::Vector2d& top_left, double width) {
  const std::vector<Eigen::Vector2d> places = places_of(items, width);
  for (std::size_t i = 0; i < items.size(); ++i) draw_item(image, items[i], top_left + places[i]);
}

void draw_scale_bar(RgbImage& image, const Eigen::Vector2d& left, double pixels_per_meter,
                    double width) {
  const double length = round_length(0.25 * width / pixels_per_meter);
  const double pixels = length * pixels_per_meter;
  const Pen pen{.color = kBlack, .width = 2.0};
  const Eigen::Vector2d right = left + Eigen::Vector2d(pixels, 0.0);
  draw_line(image, left, right, pen);
  for (const Eigen::Vector2d& end : {left, right}) {
    draw_line(image, end - Eigen::Vector2d(0, 5), end + Eigen::Vector2d(0, 5), pen);
  }
  draw_text(image, right + Eigen::Vector2d(10, 5), length_text(length), {.size = kLegendTextSize});
}

}  // namespace mapbed
