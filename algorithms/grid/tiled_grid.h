#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/check.h"

namespace mapbed {

// The place of a cell in an unbounded grid. Cell (0, 0) covers [0, resolution) x [0, resolution).
struct CellIndex {
  int x = 0;
  int y = 0;
  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

// The cells' bounding box, both corners inside it; empty where min.x > max.x.
struct CellBox {
  CellIndex min{1, 1};
  CellIndex max{0, 0};
  bool empty() const { return min.x > max.x; }
  int width() const { return max.x - min.x + 1; }
  int height() const { return max.y - min.y + 1; }
};

// An unbounded grid of square cells that holds memory only where it was written: tiles of 32 x 32
// cells, and four bytes per tile of the bounding box. A cell that was never written reads as
// Cell{}.
template <class Cell>
class TiledGrid {
 public:
  static constexpr int kTileBits = 5;
  static constexpr int kTileSide = 1 << kTileBits;
  static constexpr int kMaxTiles = 1 << 14;  // along one axis; 26 km at 5 cm

  using Tile = std::array<Cell, std::size_t{kTileSide} * kTileSide>;  // row by row

  explicit TiledGrid(double resolution) : resolution_(resolution) { CHECK(resolution > 0.0); }

  double resolution() const { return resolution_; }  // [m]

  CellIndex cell_of(const Eigen::Vector2d& point) const {
    return {static_cast<int>(std::floor(point.x() / resolution_)),
            static_cast<int>(std::floor(point.y() / resolution_))};
  }
  Eigen::Vector2d center_of(CellIndex cell) const {
    return {(cell.x + 0.5) * resolution_, (cell.y + 0.5) * resolution_};
  }

  // The cell's value, Cell{} where nothing was written near it.
  const Cell& operator[](CellIndex cell) const {
    static const Cell kUnwritten{};
    const Tile* tile = tile_of(cell);
    return tile == nullptr ? kUnwritten : (*tile)[offset_of(cell)];
  }

  // The cell for writing; makes its tile where there is none.
  Cell& at(CellIndex cell) {
    const int tile_x = cell.x >> kTileBits;
    const int tile_y = cell.y >> kTileBits;
    if (!in_directory(tile_x, tile_y)) grow(tile_x, tile_y);
    std::unique_ptr<Tile>& tile = directory_[slot_of(tile_x, tile_y)];
    if (tile == nullptr) tile = std::make_unique<Tile>();
    return (*tile)[offset_of(cell)];
  }

  // visit(cell index, cell) for every cell of every tile, row by row within a tile.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (int ty = 0; ty < height_; ++ty) {
      for (int tx = 0; tx < width_; ++tx) {
        const Tile* tile = directory_[static_cast<std::size_t>(ty) * width_ + tx].get();
        if (tile == nullptr) continue;
        for (int i = 0; i < kTileSide * kTileSide; ++i) {
          visit(CellIndex{((min_x_ + tx) << kTileBits) + (i & (kTileSide - 1)),
                          ((min_y_ + ty) << kTileBits) + (i >> kTileBits)},
                (*tile)[static_cast<std::size_t>(i)]);
        }
      }
    }
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
  static std::size_t offset_of(CellIndex cell) {
    return static_cast<std::size_t>(((cell.y & (kTileSide - 1)) << kTileBits) |
                                    (cell.x & (kTileSide - 1)));
  }
  bool in_directory(int tile_x, int tile_y) const {
    return tile_x >= min_x_ && tile_x < min_x_ + width_ && tile_y >= min_y_ &&
           tile_y < min_y_ + height_;
  }
  std::size_t slot_of(int tile_x, int tile_y) const {
    return static_cast<std::size_t>(tile_y - min_y_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(tile_x - min_x_);
  }
  const Tile* tile_of(CellIndex cell) const {
    const int tile_x = cell.x >> kTileBits;
    const int tile_y = cell.y >> kTileBits;
    return in_directory(tile_x, tile_y) ? directory_[slot_of(tile_x, tile_y)].get() : nullptr;
  }

  // Widens the directory to hold the tile, by half its size beyond, so that growth is rare.
  void grow(int tile_x, int tile_y) {
    const int old_min_x = min_x_, old_min_y = min_y_, old_width = width_, old_height = height_;
    const auto widen = [](int tile, int& min, int& size) {
      if (size == 0) {
        min = tile;
        size = 1;
      } else if (tile < min) {
        const int more = std::max(min - tile, size / 2);
        min -= more;
        size += more;
      } else if (tile >= min + size) {
        size += std::max(tile - (min + size) + 1, size / 2);
      }
    };
    widen(tile_x, min_x_, width_);
    widen(tile_y, min_y_, height_);
    CHECK(width_ <= kMaxTiles && height_ <= kMaxTiles);
    std::vector<std::unique_ptr<Tile>> wider(static_cast<std::size_t>(width_) *
                                             static_cast<std::size_t>(height_));
    for (int y = 0; y < old_height; ++y) {
      for (int x = 0; x < old_width; ++x) {
        wider[slot_of(old_min_x + x, old_min_y + y)] =
            std::move(directory_[static_cast<std::size_t>(y) * old_width + x]);
      }
    }
    directory_ = std::move(wider);
  }

  double resolution_;
  int min_x_ = 0, min_y_ = 0;  // of the directory, in tiles
  int width_ = 0, height_ = 0;
  std::vector<std::unique_ptr<Tile>> directory_;
};

}  // namespace mapbed
