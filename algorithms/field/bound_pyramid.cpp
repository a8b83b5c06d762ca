#include "algorithms/field/bound_pyramid.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr int kMaxLevels = 8;           // blocks of up to 128 x 128 shifts
constexpr int kBlocksAcross = 5;        // of the coarsest level, about
constexpr int kFullLevels = 3;          // that are not thinned
constexpr double kMostCells = 1 << 28;  // of a level, a byte each
constexpr double kMostShifts = 1LL << 32;

using Level = BoundPyramid::Level;

// An entry of the next level covers these of the level below, from the first on: two blocks beside
// each other, and where the next level is thinned the one that begins an entry later too.
struct Cover {
  int first_step = 1;  // entries below, from one entry to the next
  int offsets[2];      // [entries below] behind the first
};
Cover cover_of(int h) {
  if (h < kFullLevels) return {1, {1 << (h - 1), 1 << (h - 1)}};
  return {2, {4, 5}};
}

// Entries of the next level along one axis, from those below: [min, min + size) with a border of 0.
void next_range(int min_below, int size_below, const Cover& cover, int& min, int& size) {
  const int low = min_below - cover.offsets[1], high = min_below + size_below - 1;
  const auto floor_of = [&](int entry) { return cover.first_step == 1 ? entry : entry >> 1; };
  min = floor_of(low);
  size = floor_of(high) + 1 - min + 1;
}

template <int step>
void widen_row(const std::uint8_t* below, const Cover& cover, int count, std::uint8_t* row) {
  const std::uint8_t* second = below + cover.offsets[0];
  const std::uint8_t* third = below + cover.offsets[1];
  for (int i = 0; i < count; ++i) {
    row[i] = std::max(std::max(below[step * i], second[step * i]), third[step * i]);
  }
}

void make_next(const Level& below, int h, std::vector<std::uint8_t>& padded,
               std::vector<std::uint8_t>& rows, Level& level) {
  const Cover cover = cover_of(h);
  level.thinning = below.thinning + cover.first_step - 1;
  next_range(below.min_x, below.width, cover, level.min_x, level.width);
  next_range(below.min_y, below.height, cover, level.min_y, level.height);
  const auto width = static_cast<std::size_t>(level.width);

  // Along the rows, each with zeros about it.
  const int before = below.min_x - cover.first_step * level.min_x;  // zeros left of the row
  padded.assign(static_cast<std::size_t>(cover.first_step * level.width + cover.offsets[1] + 1), 0);
  rows.resize(width * static_cast<std::size_t>(below.height));
  for (int y = 0; y < below.height; ++y) {
    std::copy_n(below.bounds.data() + std::ptrdiff_t{y} * below.width, below.width,
                padded.begin() + before);
    std::uint8_t* row = rows.data() + static_cast<std::size_t>(y) * width;
    if (cover.first_step == 1) {
      widen_row<1>(padded.data(), cover, level.width, row);
    } else {
      widen_row<2>(padded.data(), cover, level.width, row);
    }
  }

  // And across them.
  level.bounds.assign(width * static_cast<std::size_t>(level.height) + BoundPyramid::kReadBeyond,
                      0);
  for (int y = 0; y < level.height; ++y) {
    const int first = cover.first_step * (level.min_y + y) - below.min_y;
    std::uint8_t* row = level.bounds.data() + static_cast<std::size_t>(y) * width;
    for (const int offset : {0, cover.offsets[0], cover.offsets[1]}) {
      if (first + offset < 0 || first + offset >= below.height) continue;
      const std::uint8_t* from = rows.data() + static_cast<std::size_t>(first + offset) * width;
      for (std::size_t x = 0; x < width; ++x) row[x] = std::max(row[x], from[x]);
    }
  }
}

}  // namespace

BoundPyramid make_bound_pyramid(const LikelihoodField& field, double window) {
  BoundPyramid pyramid;
  remake_bound_pyramid(field, window, pyramid);
  return pyramid;
}

void remake_bound_pyramid(const LikelihoodField& field, double window, BoundPyramid& pyramid) {
  pyramid.step = field.bound_step();
  pyramid.max_shifts = static_cast<int>(std::ceil(window / field.resolution() - 1e-9));
  int level_count = 1;
  while (level_count < kMaxLevels &&
         2 * pyramid.max_shifts + 1 > kBlocksAcross * (1 << (level_count - 1))) {
    ++level_count;
  }
  ++level_count;  // blocks that are turned as well reach farther
  pyramid.box = field.box();
  if (pyramid.box.empty()) pyramid.box = CellBox{{0, 0}, {0, 0}};
  pyramid.levels.resize(static_cast<std::size_t>(level_count));

  Level& finest = pyramid.levels.front();
  finest.min_x = pyramid.box.min.x - 1;
  finest.min_y = pyramid.box.min.y - 1;
  finest.width = pyramid.box.width() + 2;
  finest.height = pyramid.box.height() + 2;
  const double cells = static_cast<double>(finest.width) * finest.height;
  if (!(cells <= kMostCells && 4.0 * pyramid.max_shifts * pyramid.max_shifts <= kMostShifts)) {
    throw InputError(fmt::format(
        "a search over {:g} m about a map of {} x {} cells takes too long; choose larger "
        "cells or a smaller window",
        window, pyramid.box.width(), pyramid.box.height()));
  }
  finest.bounds.assign(
      static_cast<std::size_t>(finest.width) * static_cast<std::size_t>(finest.height) +
          BoundPyramid::kReadBeyond,
      0);
  const std::vector<CellIndex> tiles = field.tile_corners();
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
    const CellIndex corner = tiles[i];
    field.bound_tile(corner, finest.width,
                     finest.bounds.data() + std::ptrdiff_t{corner.y - finest.min_y} * finest.width +
                         corner.x - finest.min_x);
  });
  std::vector<std::uint8_t> padded, rows;
  for (int h = 1; h < level_count; ++h) {
    make_next(pyramid.levels[static_cast<std::size_t>(h - 1)], h, padded, rows,
              pyramid.levels[static_cast<std::size_t>(h)]);
  }
}

}  // namespace mapbed
