#include "algorithms/rbpf/surface_likelihood.h"

#include <cmath>

#include <Eigen/Dense>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr int kIterations = 4;
constexpr double kAlong = 0.1;  // of a distance along a mapped line that counts, as in the field

double squared_distance(const SurfaceMap::Nearest& nearest) {
  const double along = nearest.off.dot(nearest.along);
  return nearest.off.squaredNorm() - (1.0 - kAlong * kAlong) * along * along;
}

}  // namespace

double log_likelihood(const ScanForWeighting& scan, const SurfaceMap& map,
                      const Pose2& map_from_robot, const SurfaceLikelihoodOptions& options) {
  const double floor = std::log1p(-options.hit_share);
  const double scale = -0.5 / (options.sigma * options.sigma);
  double sum = 0.0;
  for (const Eigen::Vector2d& hit : scan.hits) {
    const SurfaceMap::Nearest nearest = map.nearest(map_from_robot * hit);
    sum += nearest.found
               ? std::log(options.hit_share * std::exp(scale * squared_distance(nearest)) + 1.0 -
                          options.hit_share)
               : floor;
  }
  for (const Eigen::Vector2d& point : scan.free) {
    const SurfaceMap::Nearest nearest = map.nearest(map_from_robot * point);
    if (nearest.found && nearest.off.squaredNorm() < map.resolution() * map.resolution())
      sum += floor;
  }
  return options.beam_weight * sum;
}

double explained_share(const ScanForWeighting& scan, const SurfaceMap& map,
                       const Pose2& map_from_robot, const SurfaceLikelihoodOptions& options) {
  if (scan.hits.empty()) return 0.0;
  const double worst =
      options.beam_weight * static_cast<double>(scan.hits.size()) * std::log1p(-options.hit_share);
  return 1.0 - log_likelihood({.hits = scan.hits}, map, map_from_robot, options) / worst;
}

LocalPosterior local_posterior(const Pose2& start, const ScanForWeighting& scan,
                               const SurfaceMap& map, const PosePrior& prior,
                               const SurfaceLikelihoodOptions& options) {
  const double scale = -0.5 / (options.sigma * options.sigma);
  LocalPosterior result{.mode = start};
  Eigen::Matrix3d information = prior.information;
  for (int i = 0; i < kIterations; ++i) {
    const Pose2 off = motion_between(prior.mean, result.mode);
    information = prior.information;
    Eigen::Vector3d g = -prior.information * Eigen::Vector3d(off.x, off.y, off.theta);
    const double c = std::cos(result.mode.theta), s = std::sin(result.mode.theta);
    for (const Eigen::Vector2d& hit : scan.hits) {
      const Eigen::Vector2d point(result.mode.x + c * hit.x() - s * hit.y(),
                                  result.mode.y + s * hit.x() + c * hit.y());
      const SurfaceMap::Nearest nearest = map.nearest(point);
      if (!nearest.found) continue;
      const double gauss = options.hit_share * std::exp(scale * squared_distance(nearest));
      const double weight = options.proposal_weight * gauss / (gauss + 1.0 - options.hit_share) /
                            (options.sigma * options.sigma);
      // In the robot's frame: where the point wants to go, and how it moves with x, y and theta.
      const auto pull = [&](const Eigen::Vector2d& normal_in_map, double residual) {
        const double nx = c * normal_in_map.x() + s * normal_in_map.y();
        const double ny = -s * normal_in_map.x() + c * normal_in_map.y();
        const Eigen::Vector3d moves(nx, ny, hit.x() * ny - hit.y() * nx);
        information.noalias() += weight * moves * moves.transpose();
        g -= weight * residual * moves;
      };
      if (nearest.along.isZero()) {
        pull({1.0, 0.0}, nearest.off.x());
        pull({0.0, 1.0}, nearest.off.y());
      } else {
        const Eigen::Vector2d across(-nearest.along.y(), nearest.along.x());
        pull(across, across.dot(nearest.off));
      }
    }
    information.diagonal().array() += 1e-6;
    const Eigen::Vector3d step = information.ldlt().solve(g);
    result.mode = result.mode * Pose2{step.x(), step.y(), normalized_angle(step.z())};
    if (step.cwiseAbs().maxCoeff() < 5e-4) break;
  }
  result.covariance = information.inverse();
  result.log_evidence =
      log_likelihood(scan, map, result.mode, options) +
      options.beam_weight / options.proposal_weight *
          (prior.log_at(result.mode) + 0.5 * std::log(result.covariance.determinant()));
  return result;
}

}  // namespace mapbed
