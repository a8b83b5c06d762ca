#include "algorithms/scan/footprint_weights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/scan/surface_points.h"
#include "core/check.h"

namespace mapbed {

std::vector<float> footprint_weights(const LaserScan& scan, double max_range, double max_gap,
                                     double sigma) {
  CHECK(sigma > 0.0);
  constexpr double kUniform = 0.5 / std::numbers::sqrt3;  // sigma of a uniform error of width 1
  const std::vector<Eigen::Vector2d> lines = lines_at_beams(scan, max_range, max_gap);
  std::vector<float> weights(scan.ranges.size(), 1.0F);
  for (std::size_t beam = 0; beam < weights.size(); ++beam) {
    const double range = scan.ranges[beam];
    if (!scan.is_hit(beam) || range >= max_range) continue;
    if (!lines[beam].isZero()) continue;
    const double across = kUniform * range * std::abs(scan.bearing_step);
    const double squared = across * across / (sigma * sigma);
    weights[beam] = static_cast<float>(1.0 / (1.0 + squared));
  }
  return weights;
}

}  // namespace mapbed
