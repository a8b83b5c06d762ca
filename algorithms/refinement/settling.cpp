#include "algorithms/refinement/settling.h"

#include <Eigen/Dense>

namespace mapbed {
PosePrior together(const PosePrior& a, const PosePrior& b) {
  const Eigen::Matrix3d information = a.information + b.information;
  const Pose2 off = motion_between(a.mean, b.mean);
  const Eigen::Vector3d step =
      information.ldlt().solve(b.information * Eigen::Vector3d(off.x, off.y, off.theta));
  return {.mean = a.mean * Pose2{step.x(), step.y(), step.z()}, .information = information};
}

namespace {

PosePrior from_neighbours(const std::vector<PathStep>& path, std::size_t i,
                          const MotionModelOptions& errors) {
  const auto from_before = [&] { return gaussian_after(path[i - 1].pose, path[i].motion, errors); };
  const auto from_after = [&] {
    return gaussian_after(path[i + 1].pose, inverse(path[i + 1].motion), errors);
  };
  if (i + 1 == path.size()) return from_before();
  return together(from_before(), from_after());
}

}  // namespace

SettledPath settled(std::vector<PathStep> path, const MotionModelOptions& motion_errors,
                    const SettlingOptions& options) {
  const SurfaceLikelihood likelihood({.sigma = options.sigma, .proposal_weight = 1.0});
  const auto map_of_all = [&] {
    SurfaceMap map(options.resolution);
    for (const PathStep& step : path) map.add(step.scan->surface, step.pose);
    return map;
  };
  for (int round = 0; round < options.rounds && path.size() > 1; ++round) {
    const SurfaceMap map = map_of_all();
    for (std::size_t i = 1; i < path.size(); ++i) {  // the first one holds the map
      const PosePrior prior = from_neighbours(path, i, motion_errors);
      path[i].pose = likelihood.local_posterior(path[i].pose, *path[i].scan, map, prior).mode;
    }
  }
  SettledPath result{.poses = {}, .map = map_of_all()};
  result.poses.reserve(path.size());
  for (const PathStep& step : path) result.poses.push_back(step.pose);
  return result;
}

Pose2 settled_beside(const std::vector<Eigen::Vector2d>& hits, const PosePrior& prior,
                     const SurfaceMap& map, const SettlingOptions& options) {
  const SurfaceLikelihood likelihood({.sigma = options.sigma, .proposal_weight = 1.0});
  return likelihood.local_posterior(prior.mean, {.hits = hits}, map, prior).mode;
}

}  // namespace mapbed
