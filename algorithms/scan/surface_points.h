#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// A point of a surface that a scan saw. The line through it and its neighbours is kept by its
// direction at twice the angle, (cos 2a, sin 2a), so that directions can be averaged: the mean's
// length tells how well they agree. Zero: no line is known.
struct SurfacePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  Eigen::Vector2d doubled = Eigen::Vector2d::Zero();
};

// The unit vector along the line of an averaged direction; zero where the directions do not agree.
Eigen::Vector2d tangent_of(const Eigen::Vector2d& mean_doubled);

std::vector<SurfacePoint> transformed(const std::vector<SurfacePoint>& points_in_b,
                                      const Pose2& a_from_b);

// The surface that the scan saw, for building maps: all hits nearer than max_range, and between
// neighbouring ones points every `spacing` [m], where they are not more than max_gap [m] apart or
// lie on one straight wall, seen at a grazing angle. Each knows the line through the hits about it,
// as far as they follow each other without a larger gap.
std::vector<SurfacePoint> surface_points(const LaserScan& scan, double max_range, double max_gap,
                                         double spacing);

// For each beam of a scan the line through the hits about its end, by its direction at twice the
// angle in the robot frame; zero where there is none.
std::vector<Eigen::Vector2d> lines_at_beams(const LaserScan& scan, double max_range,
                                            double max_gap);

}  // namespace mapbed
