#include "algorithms/people/front_end/occlusion.h"

#include <algorithm>
#include <cmath>

namespace mapbed {
namespace {

double hidden_from(const LaserScan& scan, const ScanView::Eye& eye, const Eigen::Vector2d& point,
                   double radius) {
  const double away = (point - eye.origin).norm();
  if (away <= radius) return 1.0;
  if (away - radius >= scan.max_range) return 1.0;
  const double bearing = eye.bearing_of(point);
  const double aside = std::max(radius / away, 0.5 * eye.step);
  const auto [first, last] = eye.within(bearing, aside);
  if (first == last) return 1.0;
  std::size_t hidden = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double range = scan.ranges[eye.beam(i)];
    if (!(range >= away - 2.0 * radius)) ++hidden;
  }
  return static_cast<double>(hidden) / static_cast<double>(last - first);
}

}  // namespace

double hidden_probability(const ScanView& view, const Eigen::Vector2d& point_in_robot,
                          double radius) {
  double least = 1.0;
  for (const ScanView::Eye& eye : view.eyes()) {
    least = std::min(least, hidden_from(view.scan(), eye, point_in_robot, radius));
  }
  return least;
}

OcclusionGrid occlusion_grid(const ScanView& view, double half_side, double resolution,
                             double radius) {
  OcclusionGrid grid{
      half_side, resolution, static_cast<int>(std::ceil(2.0 * half_side / resolution)), {}};
  grid.hidden.reserve(static_cast<std::size_t>(grid.cells) * static_cast<std::size_t>(grid.cells));
  for (int iy = 0; iy < grid.cells; ++iy) {
    for (int ix = 0; ix < grid.cells; ++ix) {
      const Eigen::Vector2d centre((ix + 0.5) * resolution - half_side,
                                   (iy + 0.5) * resolution - half_side);
      grid.hidden.push_back(hidden_probability(view, centre, radius));
    }
  }
  return grid;
}

}  // namespace mapbed
