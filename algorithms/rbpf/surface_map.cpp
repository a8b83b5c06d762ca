#include "algorithms/rbpf/surface_map.h"

#include <algorithm>
#include <cmath>

namespace mapbed {

const SurfaceMap::Tile* SurfaceMap::tile_at(int tile_x, int tile_y) const {
  const int x = (tile_x >> kBlockBits) - min_x_, y = (tile_y >> kBlockBits) - min_y_;
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return nullptr;
  const Block* block = blocks_[static_cast<std::size_t>(y * width_ + x)].get();
  if (block == nullptr) return nullptr;
  return block
      ->tiles[static_cast<std::size_t>(((tile_y & (kBlockSide - 1)) << kBlockBits) |
                                       (tile_x & (kBlockSide - 1)))]
      .get();
}

SurfaceMap::Tile& SurfaceMap::tile_for_writing(int tile_x, int tile_y) {
  const int block_x = tile_x >> kBlockBits, block_y = tile_y >> kBlockBits;
  const bool inside = block_x >= min_x_ && block_x < min_x_ + width_ && block_y >= min_y_ &&
                      block_y < min_y_ + height_;
  if (!inside) {
    const int low_x = width_ == 0 ? block_x : std::min(min_x_, block_x);
    const int low_y = width_ == 0 ? block_y : std::min(min_y_, block_y);
    const int high_x = width_ == 0 ? block_x : std::max(min_x_ + width_ - 1, block_x);
    const int high_y = width_ == 0 ? block_y : std::max(min_y_ + height_ - 1, block_y);
    const int width = high_x - low_x + 1, height = high_y - low_y + 1;
    std::vector<std::shared_ptr<Block>> wider(static_cast<std::size_t>(width * height));
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        wider[static_cast<std::size_t>((y + min_y_ - low_y) * width + x + min_x_ - low_x)] =
            std::move(blocks_[static_cast<std::size_t>(y * width_ + x)]);
      }
    }
    blocks_ = std::move(wider);
    min_x_ = low_x;
    min_y_ = low_y;
    width_ = width;
    height_ = height;
  }
  // use_count() is exact here: other owners only ever drop their share while this one writes, and
  // then a copy too many is made, nothing worse.
  const auto own = [](auto& shared) -> auto& {
    using T = typename std::remove_reference_t<decltype(shared)>::element_type;
    if (shared == nullptr) {
      shared = std::make_shared<T>();
    } else if (shared.use_count() > 1) {
      shared = std::make_shared<T>(*shared);
    }
    return *shared;
  };
  Block& block =
      own(blocks_[static_cast<std::size_t>((block_y - min_y_) * width_ + block_x - min_x_)]);
  return own(block.tiles[static_cast<std::size_t>(((tile_y & (kBlockSide - 1)) << kBlockBits) |
                                                  (tile_x & (kBlockSide - 1)))]);
}

void SurfaceMap::add(const std::vector<SurfacePoint>& points_in_map) {
  Tile* tile = nullptr;
  int tile_x = 0, tile_y = 0;
  for (const SurfacePoint& point : points_in_map) {
    const double x = point.position.x() / resolution_, y = point.position.y() / resolution_;
    const int cell_x = static_cast<int>(std::floor(x)), cell_y = static_cast<int>(std::floor(y));
    if (tile == nullptr || cell_x >> kTileBits != tile_x || cell_y >> kTileBits != tile_y) {
      tile_x = cell_x >> kTileBits;
      tile_y = cell_y >> kTileBits;
      tile = &tile_for_writing(tile_x, tile_y);
    }
    Cell& cell = tile->cells[static_cast<std::size_t>(((cell_y & (kTileSide - 1)) << kTileBits) |
                                                      (cell_x & (kTileSide - 1)))];
    cell.count += 1.0F;
    const float share = 1.0F / cell.count;
    cell.x += (static_cast<float>(x - cell_x) - cell.x) * share;
    cell.y += (static_cast<float>(y - cell_y) - cell.y) * share;
    cell.doubled_x += (static_cast<float>(point.doubled.x()) - cell.doubled_x) * share;
    cell.doubled_y += (static_cast<float>(point.doubled.y()) - cell.doubled_y) * share;
  }
}

SurfaceMap::Nearest SurfaceMap::nearest(const Eigen::Vector2d& point) const {
  const double px = point.x() / resolution_, py = point.y() / resolution_;
  const int center_x = static_cast<int>(std::floor(px)),
            center_y = static_cast<int>(std::floor(py));
  const auto fx = static_cast<float>(px - center_x), fy = static_cast<float>(py - center_y);
  const Cell* best = nullptr;
  float best_squared = 1e9F, best_dx = 0.0F, best_dy = 0.0F;
  const Tile* tile = tile_at(center_x >> kTileBits, center_y >> kTileBits);
  int tile_x = center_x >> kTileBits, tile_y = center_y >> kTileBits;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = center_x + dx, y = center_y + dy;
      if (x >> kTileBits != tile_x || y >> kTileBits != tile_y) {
        tile_x = x >> kTileBits;
        tile_y = y >> kTileBits;
        tile = tile_at(tile_x, tile_y);
      }
      if (tile == nullptr) continue;
      const Cell& cell = tile->cells[static_cast<std::size_t>(((y & (kTileSide - 1)) << kTileBits) |
                                                              (x & (kTileSide - 1)))];
      if (cell.count == 0.0F) continue;
      const float off_x = fx - static_cast<float>(dx) - cell.x;
      const float off_y = fy - static_cast<float>(dy) - cell.y;
      const float squared = off_x * off_x + off_y * off_y;
      if (squared >= best_squared) continue;
      best_squared = squared;
      best = &cell;
      best_dx = off_x;
      best_dy = off_y;
    }
  }
  if (best == nullptr) return {};
  return {.found = true,
          .off = resolution_ * Eigen::Vector2d(double{best_dx}, double{best_dy}),
          .along = tangent_of({double{best->doubled_x}, double{best->doubled_y}})};
}

std::size_t SurfaceMap::bytes() const {
  std::size_t sum = blocks_.size() * sizeof(blocks_[0]);
  for (const auto& block : blocks_) {
    if (block == nullptr) continue;
    sum += sizeof(Block);
    for (const auto& tile : block->tiles) sum += tile == nullptr ? 0 : sizeof(Tile);
  }
  return sum;
}

}  // namespace mapbed
