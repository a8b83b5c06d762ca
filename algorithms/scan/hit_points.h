#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/config/option.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

struct HitPointOptions {
  double max_range = 30.0;  // [m] farther hits are left out: wide footprint, coarse angle
  double min_spacing =
      0.05;              // [m] between neighbouring points; evens out how densely walls are hit
  int max_points = 180;  // spread evenly over the scan
};

template <class Visitor>
void visit_fields(HitPointOptions& o, Visitor&& visit) {
  visit("max_range", o.max_range, Unit::meter, kNotNegative, "farther hits are left out");
  visit("min_spacing", o.min_spacing, Unit::meter, kNotNegative,
        "between neighbouring points of a scan");
  visit("max_points", o.max_points, between(1, 100'000),
        "points of a scan at most, spread evenly; fewer is faster");
}

// Where the beams of a scan ended, in the robot frame [m]. Maximum-range and failed beams have no
// end.
std::vector<Eigen::Vector2d> hit_points(const LaserScan& scan, const HitPointOptions& options);

// How much each of them counts, by the weights of the scan's beams; empty where these are.
std::vector<float> hit_point_weights(const LaserScan& scan, const HitPointOptions& options,
                                     std::span<const float> beam_weights);

// All of them nearer than max_range.
std::vector<Eigen::Vector2d> all_hit_points(const LaserScan& scan, double max_range);

std::vector<Eigen::Vector2d> transformed(const std::vector<Eigen::Vector2d>& points_in_b,
                                         const Pose2& a_from_b);

}  // namespace mapbed
