#include "algorithms/field/bound_pyramid.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace mapbed {
namespace {

constexpr int kMaxLevels = 8;     // blocks of up to 128 x 128 shifts
constexpr int kBlocksAcross = 5;  // of the coarsest level, about

// The larger of a cell and those `reach` cells right, above and both. The margin keeps rows apart.
std::vector<std::uint8_t> widened(const std::vector<std::uint8_t>& fine, int width, int reach) {
  const auto right = static_cast<std::size_t>(reach);
  const auto above = right * static_cast<std::size_t>(width);
  std::vector<std::uint8_t> wide = fine;
  for (std::size_t i = 0; i + right < wide.size(); ++i)
    wide[i] = std::max(wide[i], wide[i + right]);
  for (std::size_t i = 0; i + above < wide.size(); ++i)
    wide[i] = std::max(wide[i], wide[i + above]);
  return wide;
}

}  // namespace

BoundPyramid make_bound_pyramid(const LikelihoodField& field, double window) {
  BoundPyramid pyramid;
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

  std::vector<std::uint8_t> cells(
      static_cast<std::size_t>(pyramid.width) * static_cast<std::size_t>(pyramid.height), 0);
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
  pyramid.levels.push_back(std::move(cells));
  for (int h = 0; h + 1 < level_count; ++h) {
    pyramid.levels.push_back(widened(pyramid.levels.back(), pyramid.width, 1 << h));
  }
  return pyramid;
}

}  // namespace mapbed
