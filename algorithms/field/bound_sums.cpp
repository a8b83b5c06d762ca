#include "algorithms/field/bound_sums.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <utility>

namespace mapbed {
namespace {

constexpr int kColumns = 4;  // of blocks that are read at a time
constexpr int kRows = 4;     // whose sums are held in registers
constexpr int kLargest = 255;
constexpr std::size_t kTogether = 256;  // so many bytes have a sum that two bytes hold

constexpr bool kLittle = std::endian::native == std::endian::little;

using FourInts = int __attribute__((vector_size(16)));
using EightShorts = std::uint16_t __attribute__((vector_size(16)));
using TwoLongs = std::int64_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));

// As the first bytes of a vector; those behind are 0.
template <class Word>
Bytes read(const std::uint8_t* from) {
  Word word;
  std::memcpy(&word, from, sizeof(word));
  if constexpr (sizeof(Word) == 16) return word;
  if constexpr (sizeof(Word) == 8) return std::bit_cast<Bytes>(TwoLongs{word, 0});
  if constexpr (sizeof(Word) == 4) return std::bit_cast<Bytes>(FourInts{word, 0, 0, 0});
}

// Every `stride`-th of the bytes from here on, the first four of them as widened() takes them;
// reads up to BoundPyramid::kReadBeyond further.
template <int stride>
EightShorts four_of(const std::uint8_t* from) {
  if constexpr (!kLittle) {
    return EightShorts{from[0], from[stride], from[2 * stride], from[3 * stride], 0, 0, 0, 0};
  } else if constexpr (stride == 4) {
    return std::bit_cast<EightShorts>(std::bit_cast<FourInts>(read<Bytes>(from)) & kLargest);
  } else if constexpr (stride == 2) {
    return std::bit_cast<EightShorts>(read<std::int64_t>(from)) & std::uint16_t{kLargest};
  } else {
    return std::bit_cast<EightShorts>(__builtin_shufflevector(
        read<std::int32_t>(from), Bytes{}, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
  }
}

template <int stride>
FourInts widened(EightShorts sums) {
  if constexpr (kLittle && stride == 4) return std::bit_cast<FourInts>(sums);
  return FourInts{sums[0], sums[1], sums[2], sums[3]};
}

// Points that are looked up in one level.
struct Run {
  const int *x, *y;
  std::size_t count;
};

// A level of the pyramid as it is read for up to kColumns x kRows blocks.
struct Reading {
  Reading(const BoundPyramid::Level& bounds, const BlockGrid& grid)
      : level(bounds),
        blocks(grid),
        stride((1 << grid.level) >> bounds.thinning),
        columns(static_cast<unsigned>(std::max(0, bounds.width - (grid.columns - 1) * stride))),
        rows(static_cast<unsigned>(std::max(0, bounds.height - (grid.rows - 1) * stride))) {}

  const BoundPyramid::Level& level;
  const BlockGrid& blocks;
  int stride;              // [entries] from block to block; 0: less than one
  unsigned columns, rows;  // [entries] in which the first block may lie, so that none lies outside
};

// Of a point some of whose blocks may lie outside: block by block.
template <int rows>
__attribute__((noinline)) void add_across_border(const Reading& reading, int x, int y,
                                                 FourInts* sums) {
  const BlockGrid& blocks = reading.blocks;
  const int first_x = x + blocks.x, first_y = y + blocks.y;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < blocks.columns; ++c) {
      sums[r][c] += reading.level.at(first_x + (c << blocks.level), first_y + (r << blocks.level));
    }
  }
}

template <int rows, int stride>
void add_points(const Reading& reading, const Run& run, FourInts* sums) {
  const BoundPyramid::Level& level = reading.level;
  const int thinning = level.thinning;
  const std::ptrdiff_t width = level.width, next_row = stride * width;
  const std::uint8_t* const bounds = level.bounds.data();
  const unsigned columns = reading.columns, rows_inside = reading.rows;
  const int to_column = reading.blocks.x - (level.min_x << thinning);
  const int to_row = reading.blocks.y - (level.min_y << thinning);
  // From where on the first block may lie so that one of them does not.
  const int span_x = (reading.blocks.columns - 1) * stride;
  const int span_y = (reading.blocks.rows - 1) * stride;
  const auto columns_reaching = static_cast<unsigned>(level.width + span_x);
  const auto rows_reaching = static_cast<unsigned>(level.height + span_y);
  const int *const xs = run.x, *const ys = run.y;
  for (std::size_t first = 0; first < run.count; first += kTogether) {
    const std::size_t end = std::min(run.count, first + kTogether);
    std::array<EightShorts, rows> some{};
    for (std::size_t i = first; i < end; ++i) {
      const int column = (xs[i] + to_column) >> thinning, row = (ys[i] + to_row) >> thinning;
      const bool inside =
          static_cast<unsigned>(column) < columns && static_cast<unsigned>(row) < rows_inside;
      if (!inside) {
        const bool reaches_in = static_cast<unsigned>(column + span_x) < columns_reaching &&
                                static_cast<unsigned>(row + span_y) < rows_reaching;
        if (reaches_in) add_across_border<rows>(reading, xs[i], ys[i], sums);
        continue;
      }
      const std::uint8_t* from = bounds + row * width + column;
      for (EightShorts& sum : some) {
        sum += four_of<stride>(from);
        from += next_row;
      }
    }
    for (std::size_t r = 0; r < rows; ++r) sums[r] += widened<stride>(some[r]);
  }
}

template <int rows>
void add_run(const BoundPyramid::Level& level, const BlockGrid& blocks, const Run& run,
             FourInts* sums) {
  const Reading reading(level, blocks);
  switch (reading.stride) {
    case 4:
      return add_points<rows, 4>(reading, run, sums);
    case 2:
      return add_points<rows, 2>(reading, run, sums);
    case 1:
      return add_points<rows, 1>(reading, run, sums);
    default:
      for (std::size_t i = 0; i < run.count; ++i) {
        add_across_border<rows>(reading, run.x[i], run.y[i], sums);
      }
  }
}

// Of at most kColumns blocks a row.
template <int rows>
void sum_tile(const BoundPyramid& pyramid, const PointsInCells& points, const BlockGrid& blocks,
              int* sums, int stride) {
  std::array<FourInts, rows> tile{};
  const auto run_of = [&](std::size_t first, std::size_t end) {
    return Run{points.x.data() + first, points.y.data() + first, end - first};
  };
  if (points.level.empty()) {
    add_run<rows>(pyramid.levels[static_cast<std::size_t>(blocks.level)], blocks,
                  run_of(0, points.size()), tile.data());
  }
  for (std::size_t first = 0, end = 0; first < points.level.size(); first = end) {
    const std::uint8_t level = points.level[first];
    while (end < points.level.size() && points.level[end] == level) ++end;
    if (level == PointsInCells::kUnbounded) {
      for (FourInts& row : tile) row += kLargest * static_cast<int>(end - first);
    } else {
      add_run<rows>(pyramid.levels[level], blocks, run_of(first, end), tile.data());
    }
  }
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < blocks.columns; ++c)
      sums[r * stride + c] = tile[static_cast<std::size_t>(r)][c];
  }
}

}  // namespace

void sort_by_level(PointsInCells& points) {
  std::vector<std::size_t> order(points.level.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points.level[a] < points.level[b]; });
  PointsInCells sorted;
  for (const std::size_t i : order) {
    sorted.x.push_back(points.x[i]);
    sorted.y.push_back(points.y[i]);
    sorted.level.push_back(points.level[i]);
  }
  if (!order.empty()) points = std::move(sorted);
}

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
