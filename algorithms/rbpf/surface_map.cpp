#include "algorithms/rbpf/surface_map.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <type_traits>
#include <unordered_set>

#include "algorithms/rbpf/surface_map_reader.h"

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

void SurfaceMap::widen(int block_x, int block_y) {
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

SurfaceMap::Tile& SurfaceMap::tile_for_writing(int tile_x, int tile_y) {
  const int block_x = tile_x >> kBlockBits, block_y = tile_y >> kBlockBits;
  const bool inside = block_x >= min_x_ && block_x < min_x_ + width_ && block_y >= min_y_ &&
                      block_y < min_y_ + height_;
  if (!inside) widen(block_x, block_y);
  // use_count() is exact here: other owners only ever drop their share while this one writes, and
  // then a copy too many is made, nothing worse. The fence orders our writing after their reading.
  const auto own = [](auto& shared) -> auto& {
    using T = typename std::remove_reference_t<decltype(shared)>::element_type;
    if (shared == nullptr) {
      shared = std::make_shared<T>();
    } else if (shared.use_count() > 1) {
      shared = std::make_shared<T>(*shared);
    } else {
      std::atomic_thread_fence(std::memory_order_acquire);
    }
    return *shared;
  };
  Block& block =
      own(blocks_[static_cast<std::size_t>((block_y - min_y_) * width_ + block_x - min_x_)]);
  return own(block.tiles[static_cast<std::size_t>(((tile_y & (kBlockSide - 1)) << kBlockBits) |
                                                  (tile_x & (kBlockSide - 1)))]);
}

void SurfaceMap::add(const std::vector<SurfacePoint>& points_in_map) {
  const double cells_per_meter = 1.0 / resolution_;
  Tile* tile = nullptr;
  int tile_x = 0, tile_y = 0;
  for (const SurfacePoint& point : points_in_map) {
    const double x = point.position.x() * cells_per_meter;
    const double y = point.position.y() * cells_per_meter;
    const int cell_x = floor_of(x), cell_y = floor_of(y);
    if (tile == nullptr || cell_x >> kTileBits != tile_x || cell_y >> kTileBits != tile_y) {
      tile_x = cell_x >> kTileBits;
      tile_y = cell_y >> kTileBits;
      tile = &tile_for_writing(tile_x, tile_y);
    }
    const int in_x = cell_x & (kTileSide - 1), in_y = cell_y & (kTileSide - 1);
    tile->hits[static_cast<std::size_t>(in_y)] |= static_cast<std::uint16_t>(1U << in_x);
    Cell& cell = tile->cells[static_cast<std::size_t>((in_y << kTileBits) | in_x)];
    if (cell.count < std::numeric_limits<std::uint16_t>::max()) ++cell.count;
    const float share = 1.0F / static_cast<float>(cell.count);
    const auto towards = [share](auto& mean, double value, float scale) {
      const auto old = static_cast<float>(mean);
      const float moved = old + (static_cast<float>(value) * scale - old) * share;
      mean = static_cast<std::remove_reference_t<decltype(mean)>>(moved +
                                                                  (moved < 0.0F ? -0.5F : 0.5F));
    };
    towards(cell.x, x - cell_x, kPlaceScale);
    towards(cell.y, y - cell_y, kPlaceScale);
    towards(cell.doubled_x, point.doubled.x(), kLineScale);
    towards(cell.doubled_y, point.doubled.y(), kLineScale);
  }
}

SurfaceMap::Nearest SurfaceMap::nearest(const Eigen::Vector2d& point_in_map) const {
  return Reader(*this).nearest(point_in_map.x(), point_in_map.y());
}

SurfaceMap::Reader::Candidate SurfaceMap::Reader::across_tiles(int cell_x, int cell_y, float x,
                                                               float y) const {
  Candidate best;
  for (int tile_y = (cell_y - 1) >> kTileBits; tile_y <= (cell_y + 1) >> kTileBits; ++tile_y) {
    for (int tile_x = (cell_x - 1) >> kTileBits; tile_x <= (cell_x + 1) >> kTileBits; ++tile_x) {
      const Tile* tile = map_.tile_at(tile_x, tile_y);
      if (tile == nullptr) continue;
      const int first_y = std::max(cell_y - 1, tile_y << kTileBits);
      const int last_y = std::min(cell_y + 1, (tile_y << kTileBits) + kTileSide - 1);
      const int first_x = std::max(cell_x - 1, tile_x << kTileBits);
      const int last_x = std::min(cell_x + 1, (tile_x << kTileBits) + kTileSide - 1);
      for (int at_y = first_y; at_y <= last_y; ++at_y) {
        const int in_y = at_y & (kTileSide - 1);
        const unsigned hits = tile->hits[static_cast<std::size_t>(in_y)];
        if (hits == 0) continue;
        for (int at_x = first_x; at_x <= last_x; ++at_x) {
          const int in_x = at_x & (kTileSide - 1);
          if ((hits >> in_x & 1U) == 0) continue;
          compare(tile->cells[static_cast<std::size_t>((in_y << kTileBits) | in_x)],
                  x - static_cast<float>(at_x - cell_x), y - static_cast<float>(at_y - cell_y),
                  best);
        }
      }
    }
  }
  return best;
}

std::size_t SurfaceMap::distinct_bytes(const std::vector<const SurfaceMap*>& maps) {
  std::size_t sum = 0;
  std::unordered_set<const void*> counted;
  for (const SurfaceMap* map : maps) {
    sum += map->blocks_.size() * sizeof(map->blocks_[0]);
    for (const auto& block : map->blocks_) {
      if (block == nullptr || !counted.insert(block.get()).second) continue;
      sum += sizeof(Block);
      for (const auto& tile : block->tiles) {
        if (tile != nullptr && counted.insert(tile.get()).second) sum += sizeof(Tile);
      }
    }
  }
  return sum;
}

}  // namespace mapbed
