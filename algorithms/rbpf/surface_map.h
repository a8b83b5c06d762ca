#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/local_map.h"

namespace mapbed {

// A particle's own map: for each cell that was hit the mean of the end points in it and their line,
// as in SurfaceMeans. Copies share what they have in common: cells lie in tiles, tiles in blocks,
// and both are copied only when one of several owners writes to them. So a resampled particle costs
// a few pointers, and memory grows with what particles saw differently.
class SurfaceMap {
 public:
  explicit SurfaceMap(double resolution) : resolution_(resolution) {}

  double resolution() const { return resolution_; }  // [m]

  void add(const std::vector<SurfacePoint>& points_in_map);

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
  static constexpr int kTileBits = 4, kTileSide = 1 << kTileBits;     // cells
  static constexpr int kBlockBits = 3, kBlockSide = 1 << kBlockBits;  // tiles

  // Small, as every particle reads and copies many of them.
  static constexpr float kPlaceScale = 65535.0F, kLineScale = 32767.0F;
  struct Cell {
    std::uint16_t x = 0, y = 0;  // mean of the end points from the corner [cells / kPlaceScale]
    std::int16_t doubled_x = 0, doubled_y = 0;  // mean of their lines' directions [1 / kLineScale]
    std::uint16_t count = 0;                    // stays at its largest value
  };
  struct Tile {
    std::array<std::uint16_t, kTileSide> hits{};  // bit x of row y: the cell was hit
    std::array<Cell, std::size_t{kTileSide} * kTileSide> cells{};
  };
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

  double resolution_;
  int min_x_ = 0, min_y_ = 0, width_ = 0, height_ = 0;  // [blocks]
  std::vector<std::shared_ptr<Block>> blocks_;          // row by row; null where nothing was hit
};

}  // namespace mapbed
