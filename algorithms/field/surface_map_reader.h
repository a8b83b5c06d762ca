#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "algorithms/field/processor.h"
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

  Nearest nearest(double x, double y) {  // [m] in the map frame
    const double in_cells_x = x * cells_per_meter_, in_cells_y = y * cells_per_meter_;
    return nearest(in_cells_x, in_cells_y, floor_of(in_cells_x), floor_of(in_cells_y));
  }
  // Of a point [cells] in a cell.
  Nearest nearest(double x, double y, int cell_x, int cell_y);
  double cells_per_meter() const { return cells_per_meter_; }
  static int floor_of(double x) { return SurfaceMap::floor_of(x); }

 private:
  struct Candidate {
    const Cell* cell = nullptr;
    float squared = 1e9F, x = 0.0F, y = 0.0F;  // [cells] from the mapped point to the point
  };
  // Of up to three cells of a row, those that were hit: as bits.
  static unsigned hits_in(const Tile& tile, int row, int first_x, int cells) {
    return tile.hits[static_cast<std::size_t>(row)] >> first_x & ((1U << cells) - 1U);
  }
  static unsigned bits_in_three(unsigned hits) {
    constexpr unsigned kBitsInThree = 0xe994U;  // two bits for each number up to 7
    return kBitsInThree >> 2 * hits & 3U;
  }
  // With the hit ones of up to three cells of a row; (x, y) is the point from the tile's corner
  // [cells].
  static void compare(const Tile& tile, int row, int first_x, int cells, float x, float y,
                      Candidate& best) {
    const unsigned hits = hits_in(tile, row, first_x, cells);
    if (hits == 0) return;
    const Cell* cell = tile.cells.data() + tile.place_of(first_x, row);
    for (const Cell* end = cell + bits_in_three(hits); cell != end; ++cell) {
      const float off_x = x - static_cast<float>(cell->x) / kPlaceScale;
      const float off_y = y - static_cast<float>(cell->y) / kPlaceScale;
      const float squared = off_x * off_x + off_y * off_y;
      if (squared < best.squared) best = {cell, squared, off_x, off_y};
    }
  }
  static Candidate nearest_of_nine(const Tile& tile, int middle_x, int middle_y, float x, float y);
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

// Of the cells about one that is not at the tile's border: the same as compare() row by row. What
// is hit varies from point to point, so there are no branches but for more than four candidates.
MAPBED_INLINE_LOOP inline SurfaceMap::Reader::Candidate SurfaceMap::Reader::nearest_of_nine(
    const Tile& tile, int middle_x, int middle_y, float x, float y) {
  constexpr unsigned kTogether = 4;
  using Ints = std::int32_t __attribute__((vector_size(16)));
  using Floats = float __attribute__((vector_size(16)));
  std::array<std::uint32_t, 12> places;  // of the candidates; three more are written than there are
  unsigned count = 0;
  for (int row = middle_y - 1; row <= middle_y + 1; ++row) {
    const auto first = static_cast<std::uint32_t>(tile.place_of(middle_x - 1, row));
    for (unsigned i = 0; i < 3; ++i) places[count + i] = first + i;
    count += bits_in_three(hits_in(tile, row, middle_x - 1, 3));
  }
  if (count == 0) return {};
  for (unsigned i = 0; i < 3; ++i) places[count + i] = places[0];

  const Cell* cells = tile.cells.data();
  const auto place_in_cell = [&](unsigned i) {  // x below y
    std::int32_t both = 0;
    std::memcpy(&both, cells + places[i], sizeof(both));
    return both;
  };
  std::uint64_t best = ~std::uint64_t{0};  // squared distance, not negative, as bits; then number
  for (unsigned i = 0; i < count; i += kTogether) {
    const Ints both{place_in_cell(i), place_in_cell(i + 1), place_in_cell(i + 2),
                    place_in_cell(i + 3)};
    const Floats off_x = x - __builtin_convertvector(both & 0xffff, Floats) / kPlaceScale;
    const Floats off_y = y - __builtin_convertvector(both >> 16 & 0xffff, Floats) / kPlaceScale;
    const Floats squared = off_x * off_x + off_y * off_y;
    for (unsigned k = 0; k < kTogether; ++k) {
      const std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(squared[k])} << 4;
      best = std::min(best, key | (i + k));
    }
  }
  const Cell* cell = cells + places[best & 15U];
  return {cell, 0.0F, x - static_cast<float>(cell->x) / kPlaceScale,
          y - static_cast<float>(cell->y) / kPlaceScale};
}

MAPBED_INLINE_LOOP inline SurfaceMap::Nearest SurfaceMap::Reader::nearest(double x, double y,
                                                                          int cell_x, int cell_y) {
  const int in_x = cell_x & (kTileSide - 1), in_y = cell_y & (kTileSide - 1);
  const bool within = in_x > 0 && in_x < kTileSide - 1 && in_y > 0 && in_y < kTileSide - 1;
  Candidate best;
  if (within) {
    const Tile* tile = this->tile(cell_x >> kTileBits, cell_y >> kTileBits);
    if (tile == nullptr) return {};
    const auto from_x = static_cast<float>(x - (cell_x - in_x));
    const auto from_y = static_cast<float>(y - (cell_y - in_y));
    best = nearest_of_nine(*tile, in_x, in_y, from_x, from_y);
  } else {
    best = across_tiles(cell_x, cell_y, x, y);
  }
  if (best.cell == nullptr) return {};
  return {.found = true,
          .off_x = resolution_ * best.x,
          .off_y = resolution_ * best.y,
          .doubled_x = static_cast<float>(best.cell->doubled_x) / kLineScale,
          .doubled_y = static_cast<float>(best.cell->doubled_y) / kLineScale};
}

}  // namespace mapbed
