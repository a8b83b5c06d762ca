#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mapbed {

// One surface that a part of a beam may come back from. The parts of a beam are its sub-rays; where
// a sub-ray meets glass, the surfaces behind the pane follow.
struct Echo {
  float range = 0.0F;            // [m] infinite: nothing there
  float reflectivity = 0.0F;     // [0, 1]
  float cos_incidence = 1.0F;    // of the angle between beam and surface normal
  float hit_probability = 1.0F;  // below 1 for glass: else the beam goes on to the next echo
  float fraction = 1.0F;         // of the beam's light that is in this sub-ray
  std::int32_t sub_ray = 0;      // same number: same sub-ray, by increasing range
};

// Everything about a sweep that noise needs to know: computed once, noise is drawn afterwards.
struct IdealScan {
  double time = 0.0;                      // [s] the scan's own stamp
  std::uint64_t sweep = 0;                // counts this laser's sweeps
  int laser = 0;                          // as LaserScan counts
  std::vector<Echo> echoes;               // beam after beam
  std::vector<std::uint32_t> first_echo;  // of each beam; one more at the end
  std::span<const Echo> beam(std::size_t k) const {
    return {echoes.data() + first_echo[k], first_echo[k + 1] - first_echo[k]};
  }
  std::size_t beam_count() const { return first_echo.empty() ? 0 : first_echo.size() - 1; }
};

}  // namespace mapbed
