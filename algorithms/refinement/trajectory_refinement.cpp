#include "algorithms/refinement/trajectory_refinement.h"

#include <utility>

#include <tbb/parallel_for.h>

namespace mapbed {
namespace {

PosePrior from_neighbours(const std::vector<PathStep>& path, std::size_t i,
                          const MotionModelOptions& errors) {
  const auto from_before = [&] { return gaussian_after(path[i - 1].pose, path[i].motion, errors); };
  const auto from_after = [&] {
    return gaussian_after(path[i + 1].pose, inverse(path[i + 1].motion), errors);
  };
  if (i + 1 == path.size()) return from_before();
  return fused(from_before(), from_after());
}

}  // namespace

RefinedPath refined(std::vector<PathStep> path, const MotionModelOptions& motion_errors,
                    const RefinementOptions& options) {
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
  RefinedPath result{.poses = {}, .map = map_of_all()};
  result.poses.reserve(path.size());
  for (const PathStep& step : path) result.poses.push_back(step.pose);
  return result;
}

RefinedPath refined(const std::vector<Pose2>& anchors, const std::vector<ScanForWeighting>& scans,
                    const Track& track, const RefinementOptions& options) {
  std::vector<PathStep> path;
  path.reserve(anchors.size());
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    path.push_back({anchors[i], i > 0 ? motion_to(track, i, anchors) : Pose2{}, &scans[i]});
  }
  return refined(std::move(path), track.errors, options);
}

Pose2 matched_beside(const std::vector<Eigen::Vector2d>& hits, const PosePrior& prior,
                     const SurfaceMap& map, const RefinementOptions& options) {
  const SurfaceLikelihood likelihood({.sigma = options.sigma, .proposal_weight = 1.0});
  return likelihood.local_posterior(prior.mean, {.hits = hits}, map, prior).mode;
}

Trajectory refined_trajectory(const RefinedPath& path, const Track& track,
                              const std::vector<KeptHits>& hits, const RefinementOptions& options) {
  Trajectory trajectory(track.scans.size());
  tbb::parallel_for(std::size_t{0}, track.scans.size(), [&](std::size_t i) {
    const Track::Scan& scan = track.scans[i];
    Pose2 pose = path.poses[scan.anchors - 1];
    if (!scan.is_anchor) {
      std::vector<Eigen::Vector2d> points;
      points.reserve(hits[i].size());
      for (const Eigen::Vector2f& hit : hits[i]) points.push_back(hit.cast<double>());
      pose = matched_beside(points, carried(track, scan, path.poses), path.map, options);
    }
    trajectory[i] = {scan.time, pose};
  });
  return trajectory;
}

}  // namespace mapbed
