#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/field/bound_pyramid.h"

namespace mapbed {

// Blocks of 2^level x 2^level shifts beside each other, from the first one's shifts on.
struct BlockGrid {
  int x = 0, y = 0;  // [cells]
  int level = 0;
  int columns = 1, rows = 1;
};

// Points in cells of the map, each to be looked up in the level of the pyramid that covers what it
// may be moved by within a block.
struct PointsInCells {
  std::vector<int> x, y;
  std::vector<std::uint8_t> level;  // empty: the blocks' own for all
  std::size_t size() const { return x.size(); }

  static constexpr std::uint8_t kUnbounded = 255;  // none covers so much: the largest bound
};

// Puts those of one level beside each other, which is how sum_bounds() reads them fastest.
void sort_by_level(PointsInCells& points);

// Of each block, what the points can score together at most, in steps of the pyramid: `sums` row by
// row. Several blocks are read at a time where they lie beside each other in memory.
void sum_bounds(const BoundPyramid& pyramid, const PointsInCells& points, const BlockGrid& grid,
                std::vector<int>& sums);

}  // namespace mapbed
