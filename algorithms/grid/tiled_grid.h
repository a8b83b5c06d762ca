#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include "algorithms/grid/grid_frame.h"
#include "algorithms/grid/tile_directory.h"
#include "core/check.h"

namespace mapbed {

// An unbounded grid of square cells that holds memory only where it was written, in tiles of 32 x
// 32 cells. A cell that was never written reads as Cell{}.
template <class Cell>
class TiledGrid {
 public:
  static constexpr int kTileBits = 5;
  static constexpr int kTileSide = 1 << kTileBits;

  using Tile = std::array<Cell, std::size_t{kTileSide} * kTileSide>;  // row by row
  static constexpr int kMaxTiles = TileDirectory<Tile>::kMaxTiles;    // along one axis

  explicit TiledGrid(const GridFrame& frame) : frame_(frame) { CHECK(frame.resolution > 0.0); }
  explicit TiledGrid(double resolution) : TiledGrid(GridFrame{.resolution = resolution}) {}

  const GridFrame& frame() const { return frame_; }
  double resolution() const { return frame_.resolution; }  // [m]
  CellIndex cell_of(const Eigen::Vector2d& point) const { return frame_.cell_of(point); }
  Eigen::Vector2d center_of(CellIndex cell) const { return frame_.center_of(cell); }

  // The cell's value, Cell{} where nothing was written near it.
  const Cell& operator[](CellIndex cell) const {
    static const Cell kUnwritten{};
    const Tile* tile = tiles_.find(cell.x >> kTileBits, cell.y >> kTileBits);
    return tile == nullptr ? kUnwritten : (*tile)[offset_of(cell)];
  }

  // visit(cell index, cell) for the cells of a box that lie in tiles, row by row.
  template <class Visitor>
  void for_each_in(const CellBox& box, Visitor&& visit) const {
    for (int y = box.min.y; y <= box.max.y; ++y) {
      for (int x = box.min.x; x <= box.max.x;) {
        const int end = std::min(box.max.x, x | (kTileSide - 1)) + 1;  // of the tile or the box
        const Tile* tile = tiles_.find(x >> kTileBits, y >> kTileBits);
        for (std::size_t i = offset_of({x, y}); tile != nullptr && x < end; ++x, ++i) {
          visit(CellIndex{x, y}, (*tile)[i]);
        }
        x = end;
      }
    }
  }

  // The cell for writing; makes its tile where there is none.
  Cell& at(CellIndex cell) {
    return (*tiles_.at(cell.x >> kTileBits, cell.y >> kTileBits))[offset_of(cell)];
  }

  // Writes to cells near each other in turn: remembers the tile, so that the way to it is paid once
  // per tile. Valid while the grid lives at its place.
  class Writer {
   public:
    explicit Writer(TiledGrid& grid) : tiles_(grid.tiles_) {}
    Cell& at(CellIndex cell) {
      const int tile_x = cell.x >> kTileBits;
      const int tile_y = cell.y >> kTileBits;
      if (tile_ == nullptr || tile_x != tile_x_ || tile_y != tile_y_) {
        tile_ = tiles_.at(tile_x, tile_y);
        tile_x_ = tile_x;
        tile_y_ = tile_y;
      }
      return (*tile_)[offset_of(cell)];
    }

   private:
    TileDirectory<Tile>& tiles_;
    Tile* tile_ = nullptr;
    int tile_x_ = 0, tile_y_ = 0;
  };

  std::size_t tile_count() const { return tiles_.count(); }  // those that hold memory

  // visit(cell index, cell) for every cell of every tile, row by row within a tile.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    tiles_.for_each([&](int x, int y, const Tile& tile) { visit_tile(x, y, tile, visit); });
  }
  // The same, the memory of each tile given back once it was visited: for what is turned into
  // another grid.
  template <class Visitor>
  void drain(Visitor&& visit) {
    tiles_.drain([&](int x, int y, const Tile& tile) { visit_tile(x, y, tile, visit); });
  }

  // The bounding box of the cells for which `is_known` holds.
  template <class Predicate>
  CellBox box_where(Predicate&& is_known) const {
    CellBox box{{INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN}};
    for_each([&](CellIndex cell, const Cell& value) {
      if (!is_known(value)) return;
      box.min = {std::min(box.min.x, cell.x), std::min(box.min.y, cell.y)};
      box.max = {std::max(box.max.x, cell.x), std::max(box.max.y, cell.y)};
    });
    return box.min.x > box.max.x ? CellBox{} : box;
  }

 private:
  template <class Visitor>
  static void visit_tile(int tile_x, int tile_y, const Tile& tile, Visitor& visit) {
    for (int i = 0; i < kTileSide * kTileSide; ++i) {
      visit(CellIndex{(tile_x << kTileBits) + (i & (kTileSide - 1)),
                      (tile_y << kTileBits) + (i >> kTileBits)},
            tile[static_cast<std::size_t>(i)]);
    }
  }
  static std::size_t offset_of(CellIndex cell) {
    return static_cast<std::size_t>(((cell.y & (kTileSide - 1)) << kTileBits) |
                                    (cell.x & (kTileSide - 1)));
  }

  GridFrame frame_;
  TileDirectory<Tile> tiles_;
};

}  // namespace mapbed
