#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "algorithms/grid/grid_frame.h"

namespace mapbed {

// Of each cell of a tile, the point that is nearest to its centre; of several, the first.
template <int side>
struct NearestOfTile {
  static constexpr std::size_t kCells = std::size_t{side} * side;
  static constexpr int kTogether = 16;  // cells of a row: without branches, so several at a time

  std::array<float, kCells> squared;        // [cells^2] its distance; row by row
  std::array<std::int32_t, kCells> number;  // as it was added; -1: none

  explicit NearestOfTile(float farthest_squared) {
    squared.fill(farthest_squared);
    number.fill(-1);
  }

  // A point at (u, v) [cells] that is nearest at most to the cells of a box from the tile's corner.
  void add(std::int32_t its_number, double u, double v, CellIndex corner, const CellBox& box) {
    const int low = std::max(box.min.x, 0), high = std::min(box.max.x, side - 1);
    const int first_y = std::max(box.min.y, 0), last_y = std::min(box.max.y, side - 1);
    for (int next = low; next <= high; next += kTogether) {
      const int first = std::min(next, side - kTogether);
      std::array<float, kTogether> squared_x;
      squared_x.fill(kOutside);
      for (int x = std::max(low, first); x <= std::min(high, first + kTogether - 1); ++x) {
        const auto from_x = static_cast<float>(u - (corner.x + x));
        squared_x[static_cast<std::size_t>(x - first)] = from_x * from_x;
      }
      for (int y = first_y; y <= last_y; ++y) {
        const auto from_y = static_cast<float>(v - (corner.y + y));
        const std::size_t at = static_cast<std::size_t>(y) * side + static_cast<std::size_t>(first);
        take_nearer(its_number, squared_x.data(), from_y * from_y, squared.data() + at,
                    number.data() + at);
      }
    }
  }

 private:
  static constexpr float kOutside = 1e30F;
  static constexpr int kLanes = 4;
  using Floats = float __attribute__((vector_size(16)));
  using Ints = std::int32_t __attribute__((vector_size(16)));

  static void take_nearer(std::int32_t its_number, const float* squared_x, float squared_y,
                          float* best, std::int32_t* best_number) {
    for (int k = 0; k < kTogether; k += kLanes) {
      Floats its, old;
      Ints old_number;
      std::memcpy(&its, squared_x + k, sizeof(its));
      std::memcpy(&old, best + k, sizeof(old));
      std::memcpy(&old_number, best_number + k, sizeof(old_number));
      its += squared_y;
      const Ints nearer = its < old;
      const Ints bits = ((Ints)its & nearer) | ((Ints)old & ~nearer);
      const Ints number = (its_number & nearer) | (old_number & ~nearer);
      std::memcpy(best + k, &bits, sizeof(bits));
      std::memcpy(best_number + k, &number, sizeof(number));
    }
  }
};

}  // namespace mapbed
