#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/field/likelihood_field.h"

namespace mapbed {

// A field prepared for bounding. Level h holds, for each cell, an upper bound of what a point can
// score there, shifted by 0 … 2^h - 1 cells right and up: one byte, in steps of `step` above the
// field's floor. Dense over the field's box and a margin wide enough for every shift that is
// searched.
struct BoundPyramid {
  double step = 0.0;
  int max_shifts = 0;                             // [cells]
  int min_x = 0, min_y = 0;                       // [cells] of the arrays below
  int width = 0, height = 0;                      // [cells]
  CellBox box;                                    // of the field, without the margin
  std::vector<std::vector<std::uint8_t>> levels;  // level 0 first, each row by row
};

// For shifts of up to `window` [m].
BoundPyramid make_bound_pyramid(const LikelihoodField& field, double window);

// The same into `pyramid`, whose memory is used again: a matcher makes one for each local map.
void remake_bound_pyramid(const LikelihoodField& field, double window, BoundPyramid& pyramid);

}  // namespace mapbed
