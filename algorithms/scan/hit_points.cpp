#include "algorithms/scan/hit_points.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace mapbed {
namespace {

bool is_near_hit(const LaserScan& scan, std::size_t beam, double max_range) {
  return scan.is_hit(beam) && scan.ranges[beam] < max_range;
}

// Which of a scan's hits are kept.
std::vector<std::size_t> spaced_evenly(const std::vector<Eigen::Vector2d>& hits,
                                       const HitPointOptions& options) {
  CHECK(options.max_points > 0);
  std::vector<std::size_t> spaced;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const bool near =
        !spaced.empty() && (hits[i] - hits[spaced.back()]).norm() < options.min_spacing;
    if (!near) spaced.push_back(i);
  }
  const auto limit = static_cast<std::size_t>(options.max_points);
  if (spaced.size() <= limit) return spaced;
  std::vector<std::size_t> even;
  even.reserve(limit);
  for (std::size_t i = 0; i < limit; ++i) even.push_back(spaced[i * spaced.size() / limit]);
  return even;
}

}  // namespace

std::vector<Eigen::Vector2d> all_hit_points(const LaserScan& scan, double max_range) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(scan.ranges.size());
  const bool is_of_one_place = scan.robot_from_beams.empty();
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (!is_near_hit(scan, beam, max_range)) continue;
    if (!is_of_one_place) {
      points.push_back(scan.point_on(beam, scan.ranges[beam]));
      continue;
    }
    const double range = scan.ranges[beam];
    const double bearing = scan.bearing(beam);
    points.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  const Pose2& robot_from_laser = scan.robot_from_laser.planar;
  if (!is_of_one_place || robot_from_laser == Pose2{}) return points;
  return transformed(points, robot_from_laser);
}

std::vector<Eigen::Vector2d> hit_points(const LaserScan& scan, const HitPointOptions& options) {
  const std::vector<Eigen::Vector2d> all = all_hit_points(scan, options.max_range);
  std::vector<Eigen::Vector2d> points;
  for (const std::size_t i : spaced_evenly(all, options)) points.push_back(all[i]);
  return points;
}

std::vector<float> hit_point_weights(const LaserScan& scan, const HitPointOptions& options,
                                     std::span<const float> beam_weights) {
  if (beam_weights.empty()) return {};
  CHECK(beam_weights.size() == scan.ranges.size());
  std::vector<float> of_all;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (is_near_hit(scan, beam, options.max_range)) of_all.push_back(beam_weights[beam]);
  }
  std::vector<float> weights;
  for (const std::size_t i : spaced_evenly(all_hit_points(scan, options.max_range), options)) {
    weights.push_back(of_all[i]);
  }
  return weights;
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
