#include "algorithms/field/surface_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
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

// All four at once. The last two have a sign.
inline void SurfaceMap::Cell::count_in(const NewValues& values) {
  using Words = std::uint16_t __attribute__((vector_size(8)));
  using Ints = std::int32_t __attribute__((vector_size(16)));
  constexpr Ints kSigns{0, 0, 0x8000, 0x8000};
  constexpr float kAboveZero = 65536.0F;  // where cutting off the rest rounds down
  if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
  const float fraction = 1.0F / static_cast<float>(count);
  Words words;
  static_assert(offsetof(Cell, count) == sizeof(words));
  std::memcpy(&words, this, sizeof(words));
  const Ints signed_words = (__builtin_convertvector(words, Ints) ^ kSigns) - kSigns;
  const NewValues old = __builtin_convertvector(signed_words, NewValues);
  const NewValues moved = old + (values - old) * fraction;
  const Ints rounded =
      __builtin_convertvector(moved + (kAboveZero + 0.5F), Ints) - static_cast<int>(kAboveZero);
  words = __builtin_convertvector(rounded, Words);
  std::memcpy(static_cast<void*>(this), &words, sizeof(words));
}

inline SurfaceMap::Cell& SurfaceMap::Tile::cell_for_writing(int x, int y) {
  const std::size_t place = place_of(x, y);
  std::uint32_t& row = hits[static_cast<std::size_t>(y)];
  if ((row >> x & 1U) == 0) {
    row |= 1U << x;
    for (int other = 0; other < kTileSide; ++other) {
      std::uint16_t& cells_before = before[static_cast<std::size_t>(other)];
      cells_before = static_cast<std::uint16_t>(cells_before + (other > y ? 1 : 0));
    }
    if (cells.size() == cells.capacity()) cells.reserve(cells.size() + cells.size() / 4 + 8);
    cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(place), Cell{});
  }
  return cells[place];
}

// Points on their way into the map.
struct SurfaceMap::SomePoints {
  static constexpr std::size_t kMost = 64;

  std::size_t count = 0;
  std::array<std::int32_t, kMost> cell_x, cell_y;
  std::array<NewValues, kMost> values;
  std::array<Tile*, kMost> tiles;

  int tile_x(std::size_t i) const { return cell_x[i] >> kTileBits; }
  int tile_y(std::size_t i) const { return cell_y[i] >> kTileBits; }
  bool in_tile_of_last(std::size_t i) const {
    return i > 0 && tile_x(i) == tile_x(i - 1) && tile_y(i) == tile_y(i - 1);
  }
};

// In several passes, each of which asks for the memory that the next one needs: most of the time a
// particle's map is in no near cache.
void SurfaceMap::add(SomePoints& points) {
  for (std::size_t i = 0; i < points.count; ++i) {
    if (points.in_tile_of_last(i)) continue;
    const Tile* tile = tile_at(points.tile_x(i), points.tile_y(i));
    if (tile == nullptr) continue;
    for (std::size_t line = 0; line < sizeof(Tile); line += 64) {
      __builtin_prefetch(reinterpret_cast<const char*>(tile) + line, 1);
    }
  }
  for (std::size_t i = 0; i < points.count; ++i) {
    points.tiles[i] = points.in_tile_of_last(i)
                          ? points.tiles[i - 1]
                          : &tile_for_writing(points.tile_x(i), points.tile_y(i));
  }
  constexpr int kInTile = kTileSide - 1;
  for (std::size_t i = 0; i < points.count; ++i) {
    const Tile& tile = *points.tiles[i];
    __builtin_prefetch(
        tile.cells.data() + tile.place_of(points.cell_x[i] & kInTile, points.cell_y[i] & kInTile),
        1);
  }
  for (std::size_t i = 0; i < points.count; ++i) {
    points.tiles[i]
        ->cell_for_writing(points.cell_x[i] & kInTile, points.cell_y[i] & kInTile)
        .count_in(points.values[i]);
  }
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
  SomePoints some;
  for (std::size_t begin = 0; begin < points_in_robot.size(); begin += some.count) {
    const SurfacePoint* first = points_in_robot.data() + begin;
    some.count = std::min(SomePoints::kMost, points_in_robot.size() - begin);
    for (std::size_t i = 0; i < some.count; ++i) {
      const SurfacePoint& point = first[i];
      const double x = start_x + c * point.position.x() - s * point.position.y();
      const double y = start_y + s * point.position.x() + c * point.position.y();
      some.cell_x[i] = floor_of(x);
      some.cell_y[i] = floor_of(y);
      const auto in_tile_x = static_cast<float>(x - (some.tile_x(i) << kTileBits));
      const auto in_tile_y = static_cast<float>(y - (some.tile_y(i) << kTileBits));
      const auto d_x = static_cast<float>(point.doubled.x());
      const auto d_y = static_cast<float>(point.doubled.y());
      some.values[i] = NewValues{
          std::min(kPlaceScale * in_tile_x, 65535.0F), std::min(kPlaceScale * in_tile_y, 65535.0F),
          kLineScale * (c2 * d_x - s2 * d_y), kLineScale * (s2 * d_x + c2 * d_y)};
    }
    add(some);
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
