#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// Points of a scan in the robot frame, in cells of a field: what the matchers' inner loops read.
struct FieldPoints {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> weights;  // in [0, 1]: how much each counts; empty: all count fully
  std::size_t size() const { return x.size(); }
  double total_weight() const;
};

FieldPoints to_field_points(const std::vector<Eigen::Vector2d>& points_in_robot, double resolution,
                            std::vector<float> weights = {});

}  // namespace mapbed
