#pragma once

#include <bit>
#include <cmath>
#include <cstddef>

#include "algorithms/rbpf/surface_map.h"

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
  // With a cell that was hit; (x, y) is the point from the cell's corner [cells].
  static void compare(const Cell& cell, float x, float y, Candidate& best) {
    const float off_x = x - static_cast<float>(cell.x) / kPlaceScale;
    const float off_y = y - static_cast<float>(cell.y) / kPlaceScale;
    const float squared = off_x * off_x + off_y * off_y;
    if (squared < best.squared) best = {&cell, squared, off_x, off_y};
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
  Candidate across_tiles(int cell_x, int cell_y, float x, float y) const;

  const SurfaceMap& map_;
  double cells_per_meter_;
  float resolution_;
  const Tile* tile_;
  int tile_x_ = 0, tile_y_ = 0;
};

inline SurfaceMap::Nearest SurfaceMap::Reader::nearest(double x, double y) {
  const double in_cells_x = x * cells_per_meter_, in_cells_y = y * cells_per_meter_;
  const int cell_x = floor_of(in_cells_x), cell_y = floor_of(in_cells_y);
  const auto from_x = static_cast<float>(in_cells_x - cell_x);
  const auto from_y = static_cast<float>(in_cells_y - cell_y);
  const int in_x = cell_x & (kTileSide - 1), in_y = cell_y & (kTileSide - 1);
  const bool within = in_x > 0 && in_x < kTileSide - 1 && in_y > 0 && in_y < kTileSide - 1;
  Candidate best;
  if (within) {
    const Tile* tile = this->tile(cell_x >> kTileBits, cell_y >> kTileBits);
    if (tile == nullptr) return {};
    const auto row = [&](int dy) {
      return (static_cast<unsigned>(tile->hits[static_cast<std::size_t>(in_y + dy)]) >>
              (in_x - 1)) &
             7U;
    };
    // Bit 3 (dy + 1) + dx + 1 for each of the nine cells.
    for (unsigned hit = row(-1) | row(0) << 3U | row(1) << 6U; hit != 0; hit &= hit - 1) {
      const int bit = std::countr_zero(hit);
      const int dy = (bit * 11 >> 5) - 1, dx = bit - 3 * dy - 4;
      compare(tile->cells[static_cast<std::size_t>(((in_y + dy) << kTileBits) | (in_x + dx))],
              from_x - static_cast<float>(dx), from_y - static_cast<float>(dy), best);
    }
  } else {
    best = across_tiles(cell_x, cell_y, from_x, from_y);
  }
  if (best.cell == nullptr) return {};
  return {.found = true,
          .off_x = resolution_ * best.x,
          .off_y = resolution_ * best.y,
          .doubled_x = static_cast<float>(best.cell->doubled_x) / kLineScale,
          .doubled_y = static_cast<float>(best.cell->doubled_y) / kLineScale};
}

}  // namespace mapbed
