#include "algorithms/field/field_points.h"

#include <numeric>
#include <utility>

#include "core/check.h"

namespace mapbed {

double FieldPoints::total_weight() const {
  if (weights.empty()) return static_cast<double>(size());
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

FieldPoints to_field_points(const std::vector<Eigen::Vector2d>& points_in_robot, double resolution,
                            std::vector<float> weights) {
  CHECK(weights.empty() || weights.size() == points_in_robot.size());
  FieldPoints result;
  result.weights = std::move(weights);
  result.x.reserve(points_in_robot.size());
  result.y.reserve(points_in_robot.size());
  for (const Eigen::Vector2d& point : points_in_robot) {
    result.x.push_back(static_cast<float>(point.x() / resolution));
    result.y.push_back(static_cast<float>(point.y() / resolution));
  }
  return result;
}

}  // namespace mapbed
