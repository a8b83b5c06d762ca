#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/people/front_end/scan_view.h"

namespace mapbed {

// The occlusion map of section 3.2.3 at one place: the probability that a thing of `radius` [m] at
// a point of the robot's frame cannot be seen in a scan, as the fraction of the beams across it
// that end before they come there, or failed. 1 outside of the view and beyond max_range; of
// several lasers, that which sees it best.
double hidden_probability(const ScanView& view, const Eigen::Vector2d& point_in_robot,
                          double radius);

// The same for the cells of a square about the robot, for pictures: at(ix, iy), row by row from the
// corner (-half_side, -half_side).
struct OcclusionGrid {
  double half_side = 0.0;   // [m]
  double resolution = 0.0;  // [m]
  int cells = 0;            // along a side
  std::vector<double> hidden;

  double at(int ix, int iy) const { return hidden[static_cast<std::size_t>(iy * cells + ix)]; }
};
OcclusionGrid occlusion_grid(const ScanView& view, double half_side, double resolution,
                             double radius);

}  // namespace mapbed
