#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "algorithms/field/likelihood_field.h"

namespace mapbed {

// A field prepared for bounding. Level h holds, for each cell, an upper bound of what a point can
// score there, shifted by 0 … 2^h - 1 cells right and up: one byte, in steps of `step` above the
// field's floor. Coarse levels are thinned: from level 3 on their entries stand 2^(h - 2) cells
// apart, and each one covers the cells up to the next one too. Dense over the field's box alone, so
// that neither the window nor the number of levels costs memory: 3 1/3 bytes a cell in all.
struct BoundPyramid {
  struct Level {
    int thinning = 0;                  // [bits] entries stand 2^thinning cells apart
    int min_x = 0, min_y = 0;          // [entries] of the array, whose border is 0
    int width = 0, height = 0;         // [entries]
    std::vector<std::uint8_t> bounds;  // row by row, and kReadBeyond further

    // Of a cell; everything outside is 0.
    std::uint8_t at(int x, int y) const {
      const int column = std::clamp((x >> thinning) - min_x, 0, width - 1);
      const int row = std::clamp((y >> thinning) - min_y, 0, height - 1);
      return bounds[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column)];
    }
  };
  static constexpr std::size_t kReadBeyond = 16;  // where several are read at a time
  double step = 0.0;
  int max_shifts = 0;         // [cells]
  CellBox box;                // of the field
  std::vector<Level> levels;  // level 0 first; the last is for blocks of the one before that turn
};

// For shifts of up to `window` [m].
BoundPyramid make_bound_pyramid(const LikelihoodField& field, double window);

// The same into `pyramid`, whose memory is used again: a matcher makes one for each local map.
void remake_bound_pyramid(const LikelihoodField& field, double window, BoundPyramid& pyramid);

}  // namespace mapbed
