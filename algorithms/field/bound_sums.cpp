#include "algorithms/field/bound_sums.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace mapbed {
namespace {

constexpr int kColumns = 4;  // of blocks that are read at a time
constexpr int kRows = 4;     // whose sums are held in registers
constexpr int kLargest = 255;

using FourInts = int __attribute__((vector_size(16)));
using FourShorts = std::uint16_t __attribute__((vector_size(8)));
using FourBytes = std::uint8_t __attribute__((vector_size(4)));

template <class Vector>
Vector read(const std::uint8_t* from) {
  Vector result;
  std::memcpy(&result, from, sizeof(result));
  return result;
}

// Every `stride`-th of the bytes from here on; reads up to BoundPyramid::kReadBeyond further.
FourInts four_of(const std::uint8_t* from, int stride) {
  if constexpr (std::endian::native != std::endian::little) {
    return FourInts{from[0], from[stride], from[2 * stride], from[3 * stride]};
  }
  if (stride == 4) return read<FourInts>(from) & kLargest;
  if (stride == 2) {
    return __builtin_convertvector(read<FourShorts>(from) & std::uint16_t{kLargest}, FourInts);
  }
  return __builtin_convertvector(read<FourBytes>(from), FourInts);
}

// A level of the pyramid as it is read for up to kColumns x kRows blocks.
struct Reading {
  Reading(const BoundPyramid::Level& bounds, const BlockGrid& blocks)
      : level(&bounds),
        x(blocks.x),
        y(blocks.y),
        stride((1 << blocks.level) >> bounds.thinning),
        columns(bounds.width - (blocks.columns - 1) * stride),
        rows(bounds.height - (blocks.rows - 1) * stride) {}

  const BoundPyramid::Level* level;
  int x, y;           // of the first block
  int stride;         // [entries] from block to block; 0: less than one
  int columns, rows;  // [entries] in which the first block may lie, so that none lies outside
};

template <int rows>
void add_point(const Reading& reading, int x, int y, const BlockGrid& blocks, FourInts* sums) {
  const BoundPyramid::Level& level = *reading.level;
  const int column = ((x + reading.x) >> level.thinning) - level.min_x;
  const int row = ((y + reading.y) >> level.thinning) - level.min_y;
  const bool inside = column >= 0 && row >= 0 && column < reading.columns && row < reading.rows &&
                      reading.stride > 0;
  if (inside) {
    const std::uint8_t* from = level.bounds.data() + std::ptrdiff_t{row} * level.width + column;
    const std::ptrdiff_t next_row = std::ptrdiff_t{reading.stride} * level.width;
    for (int r = 0; r < rows; ++r, from += next_row) sums[r] += four_of(from, reading.stride);
    return;
  }
  for (int r = 0; r < rows; ++r) {
    std::array<int, kColumns> row_of_them{};
    for (int c = 0; c < blocks.columns; ++c) {
      row_of_them[static_cast<std::size_t>(c)] =
          level.at(x + reading.x + (c << blocks.level), y + reading.y + (r << blocks.level));
    }
    sums[r] += FourInts{row_of_them[0], row_of_them[1], row_of_them[2], row_of_them[3]};
  }
}

// Of at most kColumns blocks a row.
template <int rows>
void sum_tile(const BoundPyramid& pyramid, const PointsInCells& points, const BlockGrid& blocks,
              int* sums, int stride) {
  std::array<FourInts, rows> tile{};
  if (points.level.empty()) {
    const Reading reading(pyramid.levels[static_cast<std::size_t>(blocks.level)], blocks);
    for (std::size_t i = 0; i < points.size(); ++i) {
      add_point<rows>(reading, points.x[i], points.y[i], blocks, tile.data());
    }
  } else {
    std::vector<Reading> readings;
    for (const BoundPyramid::Level& level : pyramid.levels) readings.emplace_back(level, blocks);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points.level[i] == PointsInCells::kUnbounded) {
        for (FourInts& row : tile) row += kLargest;
      } else {
        add_point<rows>(readings[points.level[i]], points.x[i], points.y[i], blocks, tile.data());
      }
    }
  }
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < blocks.columns; ++c)
      sums[r * stride + c] = tile[static_cast<std::size_t>(r)][c];
  }
}

}  // namespace

void sum_bounds(const BoundPyramid& pyramid, const PointsInCells& points, const BlockGrid& grid,
                std::vector<int>& sums) {
  sums.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  for (int row = 0; row < grid.rows; row += kRows) {
    for (int column = 0; column < grid.columns; column += kColumns) {
      const BlockGrid tile{grid.x + (column << grid.level), grid.y + (row << grid.level),
                           grid.level, std::min(kColumns, grid.columns - column),
                           std::min(kRows, grid.rows - row)};
      int* first = sums.data() + std::ptrdiff_t{row} * grid.columns + column;
      switch (tile.rows) {
        case 1:
          sum_tile<1>(pyramid, points, tile, first, grid.columns);
          break;
        case 2:
          sum_tile<2>(pyramid, points, tile, first, grid.columns);
          break;
        case 3:
          sum_tile<3>(pyramid, points, tile, first, grid.columns);
          break;
        default:
          sum_tile<4>(pyramid, points, tile, first, grid.columns);
      }
    }
  }
}

}  // namespace mapbed
