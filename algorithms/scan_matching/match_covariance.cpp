#include "algorithms/scan_matching/match_covariance.h"

#include <algorithm>
#include <array>

#include <Eigen/Dense>

#include "algorithms/field/likelihood_slope.h"
#include "core/check.h"

namespace mapbed {
namespace {

// H: minus the change of the slope with the pose, symmetric, without directions in which the
// likelihood is hollow.
Eigen::Matrix3d curvature_of(const FieldPoints& points, const LikelihoodField& map,
                             const Pose2& optimum, const MatchCovarianceOptions& options) {
  const double step = options.probe_step, turn = step * options.turn_per_meter;
  const std::array<Pose2, 3> probes = {Pose2{step, 0, 0}, Pose2{0, step, 0}, Pose2{0, 0, turn}};
  const std::array<double, 3> sizes = {step, step, turn};
  Eigen::Matrix3d change;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const auto slope_at = [&](const Pose2& x) {
      return likelihood_slope(points, 0, points.size(), map, x).slope;
    };
    const Eigen::Vector3d ahead = slope_at(optimum * probes[k]);
    const Eigen::Vector3d behind = slope_at(optimum * inverse(probes[k]));
    change.col(static_cast<Eigen::Index>(k)) = (behind - ahead) / (2.0 * sizes[k]);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(0.5 * (change + change.transpose()));
  return axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).asDiagonal() *
         axes.eigenvectors().transpose();
}

// S: the scatter of the slopes of groups of neighbouring points.
Eigen::Matrix3d scatter_of(const FieldPoints& points, const LikelihoodField& map,
                           const Pose2& optimum, std::size_t together) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t begin = 0; begin < points.size(); begin += together) {
    const std::size_t end = std::min(points.size(), begin + together);
    const Eigen::Vector3d slope = likelihood_slope(points, begin, end, map, optimum).slope;
    scatter += slope * slope.transpose();
  }
  return scatter;
}

}  // namespace

Eigen::Matrix3d MatchInformation::covariance(const Eigen::Matrix3d& of_prediction) const {
  // Where nothing is known, neither by the map nor by the prediction: 1 km, 1000 rad.
  const Eigen::Matrix3d known = of_prediction + 1e-6 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d inverse = (curvature + known).inverse();
  return inverse * (scatter + known) * inverse;
}

Eigen::Matrix3d MatchInformation::information() const {
  // Few groups of points may all pull one way: S is at least a small part of what it is in the mean
  // where the model is right, H.
  constexpr double kLeastScatter = 1e-3;
  const Eigen::Matrix3d scattered =
      scatter + kLeastScatter * curvature + 1e-6 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d product = curvature * scattered.ldlt().solve(curvature);
  return 0.5 * (product + product.transpose());
}

MatchInformation match_information(const Pose2& optimum, const FieldPoints& points,
                                   const LikelihoodField& map,
                                   const MatchCovarianceOptions& options) {
  CHECK(options.probe_step > 0.0 && options.turn_per_meter > 0.0 && options.beams_together > 0);
  return {curvature_of(points, map, optimum, options),
          scatter_of(points, map, optimum, static_cast<std::size_t>(options.beams_together))};
}

}  // namespace mapbed
