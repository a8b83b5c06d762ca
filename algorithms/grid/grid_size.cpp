#include "algorithms/grid/grid_size.h"

#include <cstdint>

#include <fmt/format.h>

#include "core/input_error.h"

namespace mapbed {

void check_grid_size(int tiles_x, int tiles_y) {
  constexpr std::int64_t kMostTiles = std::int64_t{1} << 25;
  const bool fits =
      tiles_x > 0 && tiles_y > 0 && tiles_x <= kMostTiles / tiles_y;  // not positive: overflow
  if (fits) return;
  throw InputError(fmt::format(
      "the robot's poses lie too far apart for a map: it would have {} x {} tiles; look "
      "for a jump in the odometry, cut the log before it, or choose larger cells",
      static_cast<std::uint32_t>(tiles_x), static_cast<std::uint32_t>(tiles_y)));
}

}  // namespace mapbed
