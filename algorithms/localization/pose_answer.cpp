#include "algorithms/localization/pose_answer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {

double PoseAnswer::largest_sigma() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()));
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

PoseAnswer answer_of(std::span<const Pose2> poses, std::span<const double> weights,
                     const PoseBinOptions& options) {
  CHECK(!poses.empty() && poses.size() == weights.size());
  const std::vector<std::size_t> groups = touching_groups(poses, options);
  std::vector<double> weight_of_group(*std::max_element(groups.begin(), groups.end()) + 1, 0.0);
  for (std::size_t i = 0; i < poses.size(); ++i) weight_of_group[groups[i]] += weights[i];
  const auto heaviest = static_cast<std::size_t>(
      std::max_element(weight_of_group.begin(), weight_of_group.end()) - weight_of_group.begin());
  PoseAnswer answer;
  answer.weight = weight_of_group[heaviest];

  double x = 0.0, y = 0.0, c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (groups[i] != heaviest) continue;
    x += weights[i] * poses[i].x;
    y += weights[i] * poses[i].y;
    c += weights[i] * std::cos(poses[i].theta);
    s += weights[i] * std::sin(poses[i].theta);
  }
  answer.mean = {x / answer.weight, y / answer.weight, std::atan2(s, c)};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (groups[i] != heaviest) continue;
    const Eigen::Vector3d off(poses[i].x - answer.mean.x, poses[i].y - answer.mean.y,
                              angle_difference(poses[i].theta, answer.mean.theta));
    answer.covariance += weights[i] / answer.weight * off * off.transpose();
  }
  return answer;
}

}  // namespace mapbed
