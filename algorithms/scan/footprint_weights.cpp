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
    double squared_cosine = 1.0;  // of the angle between beam and line
    if (!lines[beam].isZero()) {
      const double direction = scan.robot_from_beams.empty()
                                   ? scan.robot_from_laser.planar.theta + scan.bearing(beam)
                                   : scan.robot_from_beams[beam].theta;
      const Eigen::Vector2d doubled(std::cos(2.0 * direction), std::sin(2.0 * direction));
      squared_cosine = std::max(0.0, 0.5 * (1.0 + doubled.dot(lines[beam])));
    }
    const double across = kUniform * range * std::abs(scan.bearing_step);
    const double squared = across * across * squared_cosine / (sigma * sigma);
    weights[beam] = static_cast<float>(1.0 / (1.0 + squared));
  }
  return weights;
}

}  // namespace mapbed
