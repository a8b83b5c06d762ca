#include "bench/plot/map_raster.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/image/color_map.h"

namespace mapbed {
namespace {

// Half of the beams of a thin wall end in the cell before or behind it, or pass at its edges.
constexpr float kBlackFrom = 0.5F;
constexpr double kStrayLength = 1.0;     // [m]
constexpr double kStrayFraction = 0.02;  // of the known cells, at each side
constexpr double kStrayBorder = 0.5;     // [m]

// How many cells at either end of `known_cells`, counted by row or by column, hold no more than
// stray beams: less than kStrayLength known in each and all together less than kStrayFraction of
// the map. Some of them stay as a border.
struct Trim {
  int low = 0, high = 0;
};

Trim stray_ends(const std::vector<int>& known_cells, double resolution) {
  const double few = kStrayLength / resolution;
  const auto all = std::accumulate(known_cells.begin(), known_cells.end(), std::int64_t{0});
  const double allowed = kStrayFraction * static_cast<double>(all);
  const int border = static_cast<int>(kStrayBorder / resolution);
  const auto count_from = [&](auto first, auto last) {
    int count = 0;
    std::int64_t left_out = 0;
    for (auto at = first; at != last && *at < few; ++at, ++count) {
      left_out += *at;
      if (static_cast<double>(left_out) > allowed) break;
    }
    return std::max(0, count - border);
  };
  return {count_from(known_cells.begin(), known_cells.end()),
          count_from(known_cells.rbegin(), known_cells.rend())};
}

// What is known of the cells that share a pixel.
struct Block {
  float sum = 0.0F;
  float largest = 0.0F;
  int known = 0;

  // Between mean and maximum: walls stay visible, and speckles do not become walls.
  Rgb color() const {
    if (known == 0) return kUnknownColor;
    const float occupied = 0.5F * (sum / static_cast<float>(known) + largest);
    return color_of(ColorMap::gray, 1.0 - std::min(1.0F, occupied / kBlackFrom));
  }
};

}  // namespace

CellBox box_of_surroundings(const OccupancyMap& map) {
  CellBox box = known_box(map);
  if (box.empty()) return box;
  std::vector<int> in_column(static_cast<std::size_t>(box.width()));
  std::vector<int> in_row(static_cast<std::size_t>(box.height()));
  map.for_each([&](CellIndex cell, const Occupancy& occupancy) {
    if (!occupancy.known()) return;
    ++in_column[static_cast<std::size_t>(cell.x - box.min.x)];
    ++in_row[static_cast<std::size_t>(cell.y - box.min.y)];
  });
  const Trim x = stray_ends(in_column, map.resolution());
  const Trim y = stray_ends(in_row, map.resolution());
  return {{box.min.x + x.low, box.min.y + y.low}, {box.max.x - x.high, box.max.y - y.high}};
}

RgbImage image_of_cells(const OccupancyMap& map, const CellBox& box, int cells_per_pixel) {
  const int width = (box.width() + cells_per_pixel - 1) / cells_per_pixel;
  const int height = (box.height() + cells_per_pixel - 1) / cells_per_pixel;
  std::vector<Block> blocks(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  map.for_each([&](CellIndex cell, const Occupancy& occupancy) {
    if (!occupancy.known() || !box.contains(cell)) return;
    const int x = (cell.x - box.min.x) / cells_per_pixel;
    const int y = (box.max.y - cell.y) / cells_per_pixel;  // the picture's y is down
    Block& block = blocks[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                          static_cast<std::size_t>(x)];
    block.sum += occupancy.probability;
    block.largest = std::max(block.largest, occupancy.probability);
    ++block.known;
  });
  RgbImage image(width, height);
  std::transform(blocks.begin(), blocks.end(), image.pixels().begin(),
                 [](const Block& block) { return block.color(); });
  return image;
}

}  // namespace mapbed
