#include "algorithms/scan/hit_points.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace mapbed {
std::vector<Eigen::Vector2d> all_hit_points(const LaserScan& scan, double max_range) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(scan.ranges.size());
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double range = scan.ranges[beam];
    if (!scan.is_hit(beam) || range >= max_range) continue;
    const double bearing = scan.bearing(beam);
    points.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  const Pose2& robot_from_laser = scan.robot_from_laser.planar;
  if (robot_from_laser == Pose2{}) return points;
  return transformed(points, robot_from_laser);
}

std::vector<Eigen::Vector2d> hit_points(const LaserScan& scan, const HitPointOptions& options) {
  CHECK(options.max_points > 0);
  std::vector<Eigen::Vector2d> spaced;
  for (const Eigen::Vector2d& point : all_hit_points(scan, options.max_range)) {
    const bool near = !spaced.empty() && (point - spaced.back()).norm() < options.min_spacing;
    if (!near) spaced.push_back(point);
  }
  const auto limit = static_cast<std::size_t>(options.max_points);
  if (spaced.size() <= limit) return spaced;
  std::vector<Eigen::Vector2d> even;
  even.reserve(limit);
  for (std::size_t i = 0; i < limit; ++i) even.push_back(spaced[i * spaced.size() / limit]);
  return even;
}

std::vector<Eigen::Vector2d> transformed(const std::vector<Eigen::Vector2d>& points_in_b,
                                         const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.theta), s = std::sin(a_from_b.theta);
  std::vector<Eigen::Vector2d> points_in_a;
  points_in_a.reserve(points_in_b.size());
  for (const Eigen::Vector2d& p : points_in_b) {
    points_in_a.emplace_back(a_from_b.x + c * p.x() - s * p.y(),
                             a_from_b.y + s * p.x() + c * p.y());
  }
  return points_in_a;
}

}  // namespace mapbed
