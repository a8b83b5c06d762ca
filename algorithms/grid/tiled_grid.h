#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/grid_frame.h"
#include "core/check.h"

namespace mapbed {

// An unbounded grid of square cells that holds memory only where it was written: tiles of 32 x 32
// cells, and a pointer per tile of the bounding box. A cell that was never written reads as Cell{}.
template <class Cell>
class TiledGrid {
 public:
  static constexpr int kTileBits = 5;
  static constexpr int kTileSide = 1 << kTileBits;
  static constexpr int kMaxTiles = 1 << 14;  // along one axis; 26 km at 5 cm

  using Tile = std::array<Cell, std::size_t{kTileSide} * kTileSide>;  // row by row

  explicit TiledGrid(const GridFrame& frame) : frame_(frame) { CHECK(frame.resolution > 0.0); }
  explicit TiledGrid(double resolution) : TiledGrid(GridFrame{.resolution = resolution}) {}

  TiledGrid(const TiledGrid& other)
      : frame_(other.frame_),
        min_x_(other.min_x_),
        min_y_(other.min_y_),
        width_(other.width_),
        height_(other.height_),
        directory_(other.directory_.size()) {
    for (std::size_t i = 0; i < directory_.size(); ++i) {
      const Tile* tile = other.directory_[i].get();
      if (tile != nullptr) directory_[i] = std::make_unique<Tile>(*tile);
    }
  }
  TiledGrid(TiledGrid&&) noexcept = default;
  TiledGrid& operator=(const TiledGrid& other) { return *this = TiledGrid(other); }
  TiledGrid& operator=(TiledGrid&&) noexcept = default;
  ~TiledGrid() = default;

  const GridFrame& frame() const { return frame_; }
  double resolution() const { return frame_.resolution; }  // [m]
  CellIndex cell_of(const Eigen::Vector2d& point) const { return frame_.cell_of(point); }
  Eigen::Vector2d center_of(CellIndex cell) const { return frame_.center_of(cell); }

  // The cell's value, Cell{} where nothing was written near it.
  const Cell& operator[](CellIndex cell) const {
    static const Cell kUnwritten{};
    const Tile* tile = tile_of(cell);
    return tile == nullptr ? kUnwritten : (*tile)[offset_of(cell)];
  }

  // visit(cell index, cell) for the cells of a box that lie in tiles, row by row.
  template <class Visitor>
  void for_each_in(const CellBox& box, Visitor&& visit) const {
    for (int y = box.min.y; y <= box.max.y; ++y) {
      for (int x = box.min.x; x <= box.max.x;) {
        const int end = std::min(box.max.x, x | (kTileSide - 1)) + 1;  // of the tile or the box
        const Tile* tile = tile_of({x, y});
        for (std::size_t i = offset_of({x, y}); tile != nullptr && x < end; ++x, ++i) {
          visit(CellIndex{x, y}, (*tile)[i]);
        }
        x = end;
      }
    }
  }

  // The cell for writing; makes its tile where there is none.
  Cell& at(CellIndex cell) {
    return (*tile_for_writing(cell.x >> kTileBits, cell.y >> kTileBits))[offset_of(cell)];
  }

  // Writes to cells near each other in turn: remembers the tile, so that the way to it is paid once
  // per tile. Valid while the grid lives at its place.
  class Writer {
   public:
    explicit Writer(TiledGrid& grid) : grid_(grid) {}
    Cell& at(CellIndex cell) {
      const int tile_x = cell.x >> kTileBits;
      const int tile_y = cell.y >> kTileBits;
      if (tile_ == nullptr || tile_x != tile_x_ || tile_y != tile_y_) {
        tile_ = grid_.tile_for_writing(tile_x, tile_y);
        tile_x_ = tile_x;
        tile_y_ = tile_y;
      }
      return (*tile_)[offset_of(cell)];
    }

   private:
    TiledGrid& grid_;
    Tile* tile_ = nullptr;
    int tile_x_ = 0, tile_y_ = 0;
  };

  std::size_t tile_count() const {  // tiles that hold memory
    return static_cast<std::size_t>(std::count_if(
        directory_.begin(), directory_.end(), [](const auto& tile) { return tile != nullptr; }));
  }

  // visit(cell index, cell) for every cell of every tile, row by row within a tile.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (int ty = 0; ty < height_; ++ty) {
      for (int tx = 0; tx < width_; ++tx) {
        const Tile* tile = directory_[slot_of(min_x_ + tx, min_y_ + ty)].get();
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
  Tile* tile_for_writing(int tile_x, int tile_y) {
    if (!in_directory(tile_x, tile_y)) grow(tile_x, tile_y);
    std::unique_ptr<Tile>& tile = directory_[slot_of(tile_x, tile_y)];
    if (tile == nullptr) tile = std::make_unique<Tile>();
    return tile.get();
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
            std::move(directory_[static_cast<std::size_t>(y) * static_cast<std::size_t>(old_width) +
                                 static_cast<std::size_t>(x)]);
      }
    }
    directory_ = std::move(wider);
  }

  GridFrame frame_;
  int min_x_ = 0, min_y_ = 0;  // of the directory, in tiles
  int width_ = 0, height_ = 0;
  std::vector<std::unique_ptr<Tile>> directory_;
};

}  // namespace mapbed
