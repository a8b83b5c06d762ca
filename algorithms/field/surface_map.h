#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "algorithms/field/local_map.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// A particle's own map: for each cell that was hit the mean of the end points in it and their line,
// as in SurfaceMeans. Copies share what they have in common: cells lie in tiles, tiles in blocks,
// and both are copied only when one of several owners writes to them. So a resampled particle costs
// a few pointers, and memory grows with what particles saw differently.
class SurfaceMap {
 public:
  explicit SurfaceMap(double resolution) : resolution_(resolution) {}

  double resolution() const { return resolution_; }  // [m]

  void add(const std::vector<SurfacePoint>& points_in_robot, const Pose2& map_from_robot);

  // The mapped surface nearest to a point, among its cell and the eight about it.
  struct Nearest {
    bool found = false;
    float off_x = 0.0F, off_y = 0.0F;  // [m] from the mapped point to the point
    // Of its line, as SurfacePoint's: (cos 2a, sin 2a); zero: no line.
    float doubled_x = 0.0F, doubled_y = 0.0F;
  };
  Nearest nearest(const Eigen::Vector2d& point_in_map) const;

  class Reader;  // of many points, surface_map_reader.h

  // Of all that the maps hold together, what they share counted once.
  static std::size_t distinct_bytes(const std::vector<const SurfaceMap*>& maps);

 private:
  static constexpr int kTileBits = 5, kTileSide = 1 << kTileBits;     // cells
  static constexpr int kBlockBits = 3, kBlockSide = 1 << kBlockBits;  // tiles

  // Of a point that is added: as a cell's first four members, whose means they change.
  using NewValues = float __attribute__((vector_size(16)));
  struct SomePoints;

  // Small, as every particle reads and copies many of them.
  // Scales are powers of two: they divide without dividing.
  static constexpr float kPlaceScale = 2048.0F;  // a tile is 2^16 wide
  static constexpr float kLineScale = 16384.0F;
  struct Cell {          // trivial, so that they are moved as bytes
    std::uint16_t x, y;  // mean of the end points, from the tile's corner [cells / scale]
    std::int16_t doubled_x, doubled_y;  // mean of their lines' directions [1 / scale]
    std::uint16_t count;                // stays at its largest value

    void count_in(const NewValues& values);
  };
  // Only the cells that were hit: a wall passes through few of a tile, and what bounds the speed of
  // the filter is how much memory its particles read.
  struct Tile {
    std::array<std::uint32_t, kTileSide> hits{};    // bit x of row y: the cell was hit
    std::array<std::uint16_t, kTileSide> before{};  // cells that were hit in the rows before
    std::vector<Cell> cells;                        // row by row

    // Where the cell is, or would be.
    std::size_t place_of(int x, int y) const {
      const auto row = static_cast<std::size_t>(y);
      return std::size_t{before[row]} + bits_in(hits[row] & ((1U << x) - 1U));
    }
    Cell& cell_for_writing(int x, int y);  // valid until the next one
  };
  static_assert(kTileSide == 32, "as wide as a row's bits");

  static unsigned bits_in(unsigned row) {  // std::popcount is a call where SSE4 may be missing
    row -= row >> 1 & 0x55555555U;
    row = (row & 0x33333333U) + (row >> 2 & 0x33333333U);
    row = (row + (row >> 4)) & 0x0f0f0f0fU;
    return row * 0x01010101U >> 24;
  }

  struct Block {
    std::array<std::shared_ptr<Tile>, std::size_t{kBlockSide} * kBlockSide> tiles{};
  };

  static int floor_of(double x) {  // without the call that std::floor is where SSE4 may be missing
    const int towards_zero = static_cast<int>(x);
    return towards_zero - (x < towards_zero ? 1 : 0);
  }
  const Tile* tile_at(int tile_x, int tile_y) const;
  Tile& tile_for_writing(int tile_x, int tile_y);
  void widen(int block_x, int block_y);
  void add(SomePoints& points);

  double resolution_;
  int min_x_ = 0, min_y_ = 0, width_ = 0, height_ = 0;  // [blocks]
  std::vector<std::shared_ptr<Block>> blocks_;          // row by row; null where nothing was hit
};

}  // namespace mapbed
