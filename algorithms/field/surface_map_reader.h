#pragma once

#include <cmath>
#include <cstddef>

#include "algorithms/field/surface_map.h"

namespace mapbed {

// The innermost loop of the filter: reads many points of one map, remembering the tile of the last
// one, as the points of a scan follow each other. Valid until the map is written to.
class SurfaceMap::Reader {
 public:
  explicit Reader(const SurfaceMap& map)
      : map_(map),
        cells_per_meter_(1.0 / map.resolution_),
        resolution_(static_cast<float>(map.resolution_)),
        tile_(map.tile_at(0, 0)) {}

  Nearest nearest(double x, double y);  // [m] in the map frame

 private:
  struct Candidate {
    const Cell* cell = nullptr;
    float squared = 1e9F, x = 0.0F, y = 0.0F;  // [cells] from the mapped point to the point
  };
  // With the hit ones of up to three cells of a row; (x, y) is the point from the tile's corner
  // [cells]. What is hit varies from point to point: the fewer branches the better.
  static void compare(const Tile& tile, int row, int first_x, int cells, float x, float y,
                      Candidate& best) {
    const unsigned hits =
        tile.hits[static_cast<std::size_t>(row)] >> first_x & ((1U << cells) - 1U);
    if (hits == 0) return;
    const Cell* cell = tile.cells.data() + tile.place_of(first_x, row);
    constexpr unsigned kBitsInThree = 0xe994U;  // two bits for each number up to 7
    for (const Cell* end = cell + (kBitsInThree >> 2 * hits & 3U); cell != end; ++cell) {
      const float off_x = x - static_cast<float>(cell->x) / kPlaceScale;
      const float off_y = y - static_cast<float>(cell->y) / kPlaceScale;
      const float squared = off_x * off_x + off_y * off_y;
      if (squared < best.squared) best = {cell, squared, off_x, off_y};
    }
  }
  const Tile* tile(int tile_x, int tile_y) {
    if (tile_x != tile_x_ || tile_y != tile_y_) {
      tile_ = map_.tile_at(tile_x, tile_y);
      tile_x_ = tile_x;
      tile_y_ = tile_y;
    }
    return tile_;
  }
  // Where the nine cells lie in several tiles.
  Candidate across_tiles(int cell_x, int cell_y, double x, double y) const;

  const SurfaceMap& map_;
  double cells_per_meter_;
  float resolution_;
  const Tile* tile_;
  int tile_x_ = 0, tile_y_ = 0;
};

inline SurfaceMap::Nearest SurfaceMap::Reader::nearest(double x, double y) {
  const double in_cells_x = x * cells_per_meter_, in_cells_y = y * cells_per_meter_;
  const int cell_x = floor_of(in_cells_x), cell_y = floor_of(in_cells_y);
  const int in_x = cell_x & (kTileSide - 1), in_y = cell_y & (kTileSide - 1);
  const bool within = in_x > 0 && in_x < kTileSide - 1 && in_y > 0 && in_y < kTileSide - 1;
  Candidate best;
  if (within) {
    const Tile* tile = this->tile(cell_x >> kTileBits, cell_y >> kTileBits);
    if (tile == nullptr) return {};
    const auto from_x = static_cast<float>(in_cells_x - (cell_x - in_x));
    const auto from_y = static_cast<float>(in_cells_y - (cell_y - in_y));
    for (int row = in_y - 1; row <= in_y + 1; ++row) {
      compare(*tile, row, in_x - 1, 3, from_x, from_y, best);
    }
  } else {
    best = across_tiles(cell_x, cell_y, in_cells_x, in_cells_y);
  }
  if (best.cell == nullptr) return {};
  return {.found = true,
          .off_x = resolution_ * best.x,
          .off_y = resolution_ * best.y,
          .doubled_x = static_cast<float>(best.cell->doubled_x) / kLineScale,
          .doubled_y = static_cast<float>(best.cell->doubled_y) / kLineScale};
}

}  // namespace mapbed
