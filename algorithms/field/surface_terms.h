#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "algorithms/field/hit_mixture.h"
#include "algorithms/field/processor.h"

namespace mapbed {

// Some hits of a scan with the mapped surfaces nearest to them, each quantity by itself.
struct HitsOnSurface {
  static constexpr std::size_t kMost = 64;
  using Floats = std::array<float, kMost>;

  std::size_t count = 0;
  Floats arm_x, arm_y;  // [m] from the robot to the hit, along the axes of the map
  std::array<std::int32_t, kMost> found;  // 0: there is none, and what follows is 0
  Floats off_x, off_y;                    // [m] from the mapped point to the hit
  Floats doubled_x, doubled_y;            // of the mapped line; 0: none is known
};

// What each of them adds to the sums of a slope (SurfaceLikelihood::Slope). `pull` is to be taken
// away. 0 but for `log` where there is no surface.
struct SurfaceTerms {
  using Floats = HitsOnSurface::Floats;
  Floats log;
  Floats pull_x, pull_y, pull_turn;
  Floats xx, xy, yy, x_turn, y_turn, turn_turn;
};

// `weights` of the hits in [0, 1]; null: all count fully.
void surface_terms(const HitsOnSurface& hits, const HitMixture& mixture, const float* weights,
                   SurfaceTerms& terms, Processor processor = this_processor());

}  // namespace mapbed
