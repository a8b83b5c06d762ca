#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// What of a map can be seen from a place: how far, by bearing, until something occupied.
class LineOfSight {
 public:
  static constexpr int kBearings = 720;
  // [m] things on a wall are seen though the wall's cells, and its error, are in between.
  static constexpr double kThickness = 0.3;

  LineOfSight(const OccupancyMap& map, const Eigen::Vector2d& from, double reach);

  const Eigen::Vector2d& from() const { return from_; }
  bool sees(float x, float y) const;  // [m]

 private:
  Eigen::Vector2d from_;
  std::vector<float> squares_;  // [m^2] of the ranges
};

}  // namespace mapbed
