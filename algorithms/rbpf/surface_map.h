#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/grid_frame.h"
#include "algorithms/grid/likelihood_field.h"
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

  struct Cell {
    float x = 0.0F, y = 0.0F;  // mean of the end points [cells] from the cell's corner
    float doubled_x = 0.0F, doubled_y = 0.0F;  // mean of their lines' directions at twice the angle
    float count = 0.0F;
  };

  // The mapped surface nearest to a point, among its cell and the eight about it.
  struct Nearest {
    bool found = false;
    Eigen::Vector2d off = Eigen::Vector2d::Zero();    // [m] from the mapped point to the point
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  // of unit length; zero: no line
  };
  Nearest nearest(const Eigen::Vector2d& point_in_map) const;

  std::size_t bytes() const;  // of all blocks and tiles reachable, shared ones counted in full

 private:
  static constexpr int kTileBits = 4, kTileSide = 1 << kTileBits;     // cells
  static constexpr int kBlockBits = 3, kBlockSide = 1 << kBlockBits;  // tiles

  struct Tile {
    std::array<Cell, std::size_t{kTileSide} * kTileSide> cells{};
  };
  struct Block {
    std::array<std::shared_ptr<Tile>, std::size_t{kBlockSide} * kBlockSide> tiles{};
  };

  const Tile* tile_at(int tile_x, int tile_y) const;
  Tile& tile_for_writing(int tile_x, int tile_y);

  double resolution_;
  int min_x_ = 0, min_y_ = 0, width_ = 0, height_ = 0;  // [blocks]
  std::vector<std::shared_ptr<Block>> blocks_;          // row by row; null where nothing was hit
};

}  // namespace mapbed
