#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "worlds/world.h"

namespace mapbed {

// The world's own true map at one height: what a perfect robot would draw, for metrics only.
enum class TrueCell : std::uint8_t {
  unknown,   // nobody gets or sees there
  free,      // reachable from the world's paths (from everywhere where it has none)
  occupied,  // a solid reaches into the cell, and a free one is next to it
  interior,  // a solid reaches into the cell, all around it are solid or unknown
};

struct TrueMap {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // [m] the low corner of cell (0, 0)
  double resolution = 0.05;                          // [m]
  int width = 0;                                     // cells along x
  int height = 0;                                    // cells along y
  std::vector<TrueCell> cells;                       // row by row from low y
  std::vector<std::int32_t> entities;                // what is in the cell; -1: nothing

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  TrueCell at(int x, int y) const { return cells[index(x, y)]; }
};

struct RasterOptions {
  double height = 0.3;       // [m] of the cut, usually the laser's
  double resolution = 0.05;  // [m]
  double margin = 0.5;       // [m] kept around the world
  double max_cells = 1e8;    // more would not fit into memory
  double max_looks = 3e8;    // of cells at corners of things; more would take too long
};

// Doors as they stand. Throws InputError where the map would not fit into memory, or take too long.
TrueMap raster(const World& world, const RasterOptions& options = {});

}  // namespace mapbed
