// LikelihoodField::bound_tile, a loop of its own.

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/field/likelihood_field.h"
#include "algorithms/field/processor.h"
#include "core/check.h"

namespace mapbed {
namespace {

constexpr float kLineLength = 0.99499F;  // sqrt(1 - kAlong^2), rounded up

}  // namespace

void LikelihoodField::bound_tile(CellIndex corner, int stride, std::uint8_t* bounds) const {
  static_assert(double{kLineLength} * double{kLineLength} >= 1.0 - kAlong * kAlong);
  const int tile_x = (corner.x >> kTileBits) - min_x_, tile_y = (corner.y >> kTileBits) - min_y_;
  const std::int32_t slot = directory_[static_cast<std::size_t>(tile_y * width_ + tile_x)];
  CHECK(slot >= 0);
  const Cell* cell = &cells_[static_cast<std::size_t>(slot) * kTileCells];
  const auto last_bound = static_cast<float>(bounds_.size() - 1);
  const float bounds_per_square = bounds_per_square_;
  const std::uint8_t* table = bounds_.data();
  run(this_processor(), [=]() MAPBED_INLINE_LOOP {
    for (int y = 0; y < kTileSide; ++y) {
      std::array<int, kTileSide> indices;
      for (int x = 0; x < kTileSide; ++x) {  // without branches: so it is vectorized
        const Cell& c = cell[y * kTileSide + x];
        // No nearer than the line, and where there is none no nearer than the mapped point.
        const float across = std::abs(c.x * c.along_y - c.y * c.along_x);
        const float reach = 0.5F * (std::abs(c.along_x) + std::abs(c.along_y));
        const float line = std::max(0.0F, across - reach) * (1.0F / kLineLength);
        const float dx = std::max(0.0F, std::abs(c.x) - 0.5F);
        const float dy = std::max(0.0F, std::abs(c.y) - 0.5F);
        const float squared = reach > 0.0F ? line * line : dx * dx + dy * dy;
        indices[static_cast<std::size_t>(x)] =
            static_cast<int>(std::min(squared * bounds_per_square, last_bound));
      }
      std::uint8_t* row = bounds + std::ptrdiff_t{y} * stride;
      for (int x = 0; x < kTileSide; ++x) row[x] = table[indices[static_cast<std::size_t>(x)]];
    }
  });
}

}  // namespace mapbed
