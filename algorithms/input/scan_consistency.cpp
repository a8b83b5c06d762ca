#include "algorithms/input/scan_consistency.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

// To the line between neighbouring points that are near each other, else to the point [m^2].
double squared_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  constexpr double kWall = 0.3;  // [m] between points of one surface
  const Eigen::Vector2d along = b - a;
  const double length = along.squaredNorm();
  if (length == 0.0 || length > kWall * kWall) return (p - a).squaredNorm();
  const double fraction = std::clamp((p - a).dot(along) / length, 0.0, 1.0);
  return (p - a - fraction * along).squaredNorm();
}

}  // namespace

double mismatch(const std::vector<Eigen::Vector2d>& in_a, const std::vector<Eigen::Vector2d>& in_b,
                const Pose2& a_from_b, double reach) {
  if (in_a.empty() || in_b.empty()) return reach;
  double sum = 0.0;
  for (const Eigen::Vector2d& point : in_b) {
    const Eigen::Vector2d p = a_from_b * point;
    double least = (p - in_a.back()).squaredNorm();
    for (std::size_t i = 0; i + 1 < in_a.size(); ++i) {
      // Most points are far: the line is looked at near its beginning alone.
      const double to_point = (p - in_a[i]).squaredNorm();
      if (to_point < 4.0 * reach * reach) {
        least = std::min({least, to_point, squared_distance(p, in_a[i], in_a[i + 1])});
      }
    }
    sum += std::min(reach, std::sqrt(least));
  }
  return sum / static_cast<double>(in_b.size());
}

}  // namespace mapbed
