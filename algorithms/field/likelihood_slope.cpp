#include "algorithms/field/likelihood_slope.h"

#include <cmath>

namespace mapbed {

LikelihoodSlope likelihood_slope(const FieldPoints& points, std::size_t begin, std::size_t end,
                                 const LikelihoodField& map, const Pose2& map_from_robot) {
  const double c = std::cos(map_from_robot.theta), s = std::sin(map_from_robot.theta);
  Eigen::Matrix2d rotation;
  rotation << c, -s, s, c;
  LikelihoodSlope sum;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector2d p =
        Eigen::Vector2d(double{points.x[i]}, double{points.y[i]}) * map.resolution();
    LikelihoodField::Shape shape = map.shape_at(map_from_robot * p);
    if (!points.weights.empty()) {
      shape.slope *= double{points.weights[i]};
      shape.curvature *= double{points.weights[i]};
    }
    Eigen::Matrix<double, 2, 3> moves;  // of the point in the map, with steps of the robot
    moves << rotation, rotation * Eigen::Vector2d(-p.y(), p.x());
    sum.slope += moves.transpose() * shape.slope;
    sum.curvature += moves.transpose() * shape.curvature * moves;
  }
  return sum;
}

}  // namespace mapbed
