#include "algorithms/scan_matching/match_covariance.h"

#include <cmath>

#include <Eigen/Dense>

#include "core/geometry/pose2.h"

namespace mapbed {
Eigen::Matrix3d match_covariance(const FieldPoints& points, const LikelihoodField& map,
                                 const PosePrior& prediction, const Pose2& map_from_robot) {
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero(), scatter = Eigen::Matrix3d::Zero();
  const double c = std::cos(map_from_robot.theta), s = std::sin(map_from_robot.theta);
  Eigen::Matrix2d robot_from_map;
  robot_from_map << c, s, -s, c;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d p =
        Eigen::Vector2d(double{points.x[i]}, double{points.y[i]}) * map.resolution();
    const LikelihoodField::Shape shape = map.shape_at(map_from_robot * p);
    // How the point moves, in the robot's frame, with the pose's x, y, theta.
    Eigen::Matrix<double, 2, 3> moves;
    moves << 1, 0, -p.y(), 0, 1, p.x();
    const Eigen::Vector3d gradient = moves.transpose() * (robot_from_map * shape.slope);
    scatter += gradient * gradient.transpose();
    curvature +=
        moves.transpose() * robot_from_map * shape.curvature * robot_from_map.transpose() * moves;
  }
  const Eigen::Matrix3d tiny = 1e-6 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d inverse = (curvature + prediction.information + tiny).inverse();
  return inverse * (scatter + prediction.information + tiny) * inverse;
}

}  // namespace mapbed
