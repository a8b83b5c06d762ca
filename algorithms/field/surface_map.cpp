#include "algorithms/field/surface_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>
#include <unordered_set>

#include "algorithms/field/surface_map_reader.h"
#include "algorithms/grid/grid_size.h"

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
  check_grid_size(width, height);
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

inline void SurfaceMap::Cell::count_in(float new_x, float new_y, float new_doubled_x,
                                       float new_doubled_y) {
  if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
  const float fraction = 1.0F / static_cast<float>(count);
  constexpr float kAboveZero = 65536.0F;  // where cutting off the rest rounds down
  const auto towards = [fraction](auto& mean, float value) {
    const auto old = static_cast<float>(mean);
    const float moved = old + (value - old) * fraction;
    mean = static_cast<std::remove_reference_t<decltype(mean)>>(
        static_cast<int>(moved + (kAboveZero + 0.5F)) - static_cast<int>(kAboveZero));
  };
  towards(x, std::min(kPlaceScale * new_x, 65535.0F));
  towards(y, std::min(kPlaceScale * new_y, 65535.0F));
  towards(doubled_x, kLineScale * new_doubled_x);
  towards(doubled_y, kLineScale * new_doubled_y);
}

inline SurfaceMap::Cell& SurfaceMap::Tile::cell_for_writing(int x, int y) {
  const std::size_t place = place_of(x, y);
  std::uint32_t& row = hits[static_cast<std::size_t>(y)];
  if ((row >> x & 1U) == 0) {
    row |= 1U << x;
    for (int after = y + 1; after < kTileSide; ++after) ++before[static_cast<std::size_t>(after)];
    cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(place), Cell{});
  }
  return cells[place];
}

void SurfaceMap::add(const std::vector<SurfacePoint>& points_in_robot,
                     const Pose2& map_from_robot) {
  const double cells_per_meter = 1.0 / resolution_;
  const double c = cells_per_meter * std::cos(map_from_robot.theta);
  const double s = cells_per_meter * std::sin(map_from_robot.theta);
  const double start_x = cells_per_meter * map_from_robot.x;
  const double start_y = cells_per_meter * map_from_robot.y;
  const auto c2 = static_cast<float>(std::cos(2.0 * map_from_robot.theta));
  const auto s2 = static_cast<float>(std::sin(2.0 * map_from_robot.theta));
  Tile* tile = nullptr;
  int tile_x = 0, tile_y = 0;
  for (const SurfacePoint& point : points_in_robot) {
    const double x = start_x + c * point.position.x() - s * point.position.y();
    const double y = start_y + s * point.position.x() + c * point.position.y();
    const int cell_x = floor_of(x), cell_y = floor_of(y);
    if (tile == nullptr || cell_x >> kTileBits != tile_x || cell_y >> kTileBits != tile_y) {
      tile_x = cell_x >> kTileBits;
      tile_y = cell_y >> kTileBits;
      tile = &tile_for_writing(tile_x, tile_y);
    }
    const auto d_x = static_cast<float>(point.doubled.x());
    const auto d_y = static_cast<float>(point.doubled.y());
    tile->cell_for_writing(cell_x & (kTileSide - 1), cell_y & (kTileSide - 1))
        .count_in(static_cast<float>(x - (tile_x << kTileBits)),
                  static_cast<float>(y - (tile_y << kTileBits)), c2 * d_x - s2 * d_y,
                  s2 * d_x + c2 * d_y);
  }
}

SurfaceMap::Nearest SurfaceMap::nearest(const Eigen::Vector2d& point_in_map) const {
  return Reader(*this).nearest(point_in_map.x(), point_in_map.y());
}

SurfaceMap::Reader::Candidate SurfaceMap::Reader::across_tiles(int cell_x, int cell_y, double x,
                                                               double y) const {
  Candidate best;
  for (int tile_y = (cell_y - 1) >> kTileBits; tile_y <= (cell_y + 1) >> kTileBits; ++tile_y) {
    for (int tile_x = (cell_x - 1) >> kTileBits; tile_x <= (cell_x + 1) >> kTileBits; ++tile_x) {
      const Tile* tile = map_.tile_at(tile_x, tile_y);
      if (tile == nullptr) continue;
      const int corner_x = tile_x << kTileBits, corner_y = tile_y << kTileBits;
      const int first_x = std::max(cell_x - 1 - corner_x, 0);
      const int last_x = std::min(cell_x + 1 - corner_x, kTileSide - 1);
      const int first_y = std::max(cell_y - 1 - corner_y, 0);
      const int last_y = std::min(cell_y + 1 - corner_y, kTileSide - 1);
      const auto from_x = static_cast<float>(x - corner_x);
      const auto from_y = static_cast<float>(y - corner_y);
      for (int row = first_y; row <= last_y; ++row) {
        compare(*tile, row, first_x, last_x - first_x + 1, from_x, from_y, best);
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
        if (tile == nullptr || !counted.insert(tile.get()).second) continue;
        sum += sizeof(Tile) + tile->cells.capacity() * sizeof(Cell);
      }
    }
  }
  return sum;
}

}  // namespace mapbed
