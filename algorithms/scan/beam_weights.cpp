#include "algorithms/scan/beam_weights.h"

#include "core/check.h"

namespace mapbed {

LaserScan with_failed_beams(LaserScan scan, std::span<const float> beam_weights) {
  CHECK(beam_weights.size() == scan.ranges.size());
  for (std::size_t beam = 0; beam < beam_weights.size(); ++beam) {
    CHECK(beam_weights[beam] >= 0.0F && beam_weights[beam] <= 1.0F);
    if (beam_weights[beam] == 0.0F) scan.ranges[beam] = 0.0;
  }
  return scan;
}

}  // namespace mapbed
