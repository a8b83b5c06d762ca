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
constexpr double kMostCells = 1 << 27;  // of a level, a byte each

// The larger of a cell and those `reach` cells right, above and both. The margin keeps rows apart.
void widen(const std::vector<std::uint8_t>& fine, int width, int reach,
           std::vector<std::uint8_t>& wide) {
  const auto right = static_cast<std::size_t>(reach);
  const auto above = right * static_cast<std::size_t>(width);
  wide = fine;
  std::uint8_t* cells = wide.data();  // a pointer of its own: so the loops are vectorized
  const std::size_t count = wide.size();
  for (std::size_t i = 0; i + right < count; ++i) cells[i] = std::max(cells[i], cells[i + right]);
  for (std::size_t i = 0; i + above < count; ++i) cells[i] = std::max(cells[i], cells[i + above]);
}

}  // namespace

BoundPyramid make_bound_pyramid(const LikelihoodField& field, double window) {
  BoundPyramid pyramid;
  remake_bound_pyramid(field, window, pyramid);
  return pyramid;
}

void remake_bound_pyramid(const LikelihoodField& field, double window, BoundPyramid& pyramid) {
  pyramid.step = -double{field.outlier_log()} / 255.0;
  pyramid.max_shifts = static_cast<int>(std::ceil(window / field.resolution() - 1e-9));
  int level_count = 1;
  while (level_count < kMaxLevels &&
         2 * pyramid.max_shifts + 1 > kBlocksAcross * (1 << (level_count - 1))) {
    ++level_count;
  }
  // A point is at most max_shifts + 1 outside the box; shifting and widening move it on.
  const int margin = 2 * (pyramid.max_shifts + 1) + 2 * (1 << level_count);
  const CellBox box = field.box();
  pyramid.box = box;
  if (box.empty()) pyramid.box = CellBox{{0, 0}, {0, 0}};
  pyramid.min_x = pyramid.box.min.x - margin;
  pyramid.min_y = pyramid.box.min.y - margin;
  pyramid.width = pyramid.box.width() + 2 * margin;
  pyramid.height = pyramid.box.height() + 2 * margin;

  const double size = static_cast<double>(pyramid.width) * pyramid.height;
  if (!(size <= kMostCells)) {
    throw InputError(fmt::format(
        "a search over {:g} m about a map of {} x {} cells takes too much memory; choose larger "
        "cells or a smaller window",
        window, pyramid.box.width(), pyramid.box.height()));
  }
  pyramid.levels.resize(static_cast<std::size_t>(level_count));
  std::vector<std::uint8_t>& cells = pyramid.levels.front();
  cells.assign(static_cast<std::size_t>(pyramid.width) * static_cast<std::size_t>(pyramid.height),
               0);
  const std::size_t rows = box.empty() ? 0 : static_cast<std::size_t>(box.height());
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row_number) {
    const int y = box.min.y + static_cast<int>(row_number);
    std::uint8_t* row =
        cells.data() + std::ptrdiff_t{y - pyramid.min_y} * pyramid.width - pyramid.min_x;
    for (int x = box.min.x; x <= box.max.x; ++x) {
      const double above = double{field.highest_in({x, y})} - double{field.outlier_log()};
      row[x] = static_cast<std::uint8_t>(std::min(255.0, std::ceil(above / pyramid.step - 1e-9)));
    }
  });
  for (std::size_t h = 0; h + 1 < pyramid.levels.size(); ++h)
    widen(pyramid.levels[h], pyramid.width, 1 << h, pyramid.levels[h + 1]);
}

}  // namespace mapbed
