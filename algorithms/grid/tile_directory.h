#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "algorithms/grid/grid_size.h"

namespace mapbed {

// Tiles by their place in an unbounded plane: a pointer for each of the bounding box, null where
// there is none.
template <class Tile>
class TileDirectory {
 public:
  static constexpr int kMaxTiles = 1 << 14;  // along one axis; 26 km at 5 cm and 32 cells a tile

  TileDirectory() = default;
  TileDirectory(const TileDirectory& other)
      : min_x_(other.min_x_),
        min_y_(other.min_y_),
        width_(other.width_),
        height_(other.height_),
        tiles_(other.tiles_.size()) {
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      const Tile* tile = other.tiles_[i].get();
      if (tile != nullptr) tiles_[i] = std::make_unique<Tile>(*tile);
    }
  }
  TileDirectory(TileDirectory&&) noexcept = default;
  TileDirectory& operator=(const TileDirectory& other) { return *this = TileDirectory(other); }
  TileDirectory& operator=(TileDirectory&&) noexcept = default;
  ~TileDirectory() = default;

  const Tile* find(int x, int y) const {
    return covers(x, y) ? tiles_[slot_of(x, y)].get() : nullptr;
  }

  // Makes the tile where there is none.
  Tile* at(int x, int y) {
    if (!covers(x, y)) grow(x, y);
    std::unique_ptr<Tile>& tile = tiles_[slot_of(x, y)];
    if (tile == nullptr) tile = std::make_unique<Tile>();
    return tile.get();
  }

  std::size_t count() const {  // of the tiles that there are
    return static_cast<std::size_t>(std::count_if(
        tiles_.begin(), tiles_.end(), [](const auto& tile) { return tile != nullptr; }));
  }

  // visit(x, y, tile) for every tile, row by row.
  template <class Visitor>
  void for_each(Visitor&& visit) const {
    for (int y = min_y_; y < min_y_ + height_; ++y) {
      for (int x = min_x_; x < min_x_ + width_; ++x) {
        const Tile* tile = tiles_[slot_of(x, y)].get();
        if (tile != nullptr) visit(x, y, *tile);
      }
    }
  }

  // The same, each tile freed once it was visited.
  template <class Visitor>
  void drain(Visitor&& visit) {
    for (int y = min_y_; y < min_y_ + height_; ++y) {
      for (int x = min_x_; x < min_x_ + width_; ++x) {
        const std::unique_ptr<Tile> tile = std::move(tiles_[slot_of(x, y)]);
        if (tile != nullptr) visit(x, y, *tile);
      }
    }
  }

 private:
  bool covers(int x, int y) const {
    return x >= min_x_ && x < min_x_ + width_ && y >= min_y_ && y < min_y_ + height_;
  }
  std::size_t slot_of(int x, int y) const {
    return static_cast<std::size_t>(y - min_y_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x - min_x_);
  }

  // Widens the bounding box to hold the tile, by half its size beyond, so that growth is rare.
  void grow(int x, int y) {
    TileDirectory wider;
    wider.min_x_ = min_x_, wider.min_y_ = min_y_, wider.width_ = width_, wider.height_ = height_;
    widen(x, wider.min_x_, wider.width_);
    widen(y, wider.min_y_, wider.height_);
    check_grid_size(wider.width_, wider.height_);
    wider.tiles_.resize(static_cast<std::size_t>(wider.width_) *
                        static_cast<std::size_t>(wider.height_));
    for (int ty = min_y_; ty < min_y_ + height_; ++ty) {
      for (int tx = min_x_; tx < min_x_ + width_; ++tx) {
        wider.tiles_[wider.slot_of(tx, ty)] = std::move(tiles_[slot_of(tx, ty)]);
      }
    }
    *this = std::move(wider);
  }

  static void widen(int tile, int& min, int& size) {
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
  }

  int min_x_ = 0, min_y_ = 0;
  int width_ = 0, height_ = 0;
  std::vector<std::unique_ptr<Tile>> tiles_;  // row by row
};

}  // namespace mapbed
