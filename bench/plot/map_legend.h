#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/image/image.h"

namespace mapbed {

inline constexpr int kLegendRow = 26;            // [pixels]
inline constexpr double kLegendTextSize = 15.0;  // [pixels]

// A sample and what it means.
struct LegendItem {
  enum class Kind { line, disc, area } kind;
  Rgb color;
  std::string text;
};

// Occupied, free and unknown.
std::vector<LegendItem> legend_of_cells();

// How many rows of the legend it takes within so many pixels.
int legend_rows(const std::vector<LegendItem>& items, double width);

// Left to right in as many rows as needed; `top_left` is the middle of the first one's left end.
void draw_legend(RgbImage& image, const std::vector<LegendItem>& items,
                 const Eigen::Vector2d& top_left, double width);

// A round length, a quarter of `width` at most, with its number; `left` is its left end.
void draw_scale_bar(RgbImage& image, const Eigen::Vector2d& left, double pixels_per_meter,
                    double width);

}  // namespace mapbed
