#include "algorithms/refinement/settled_estimate.h"

#include <algorithm>
#include <utility>

#include <tbb/parallel_for.h>

namespace mapbed {
namespace {

const Break* break_before(std::size_t update, const std::vector<Break>& breaks) {
  const auto found = std::find_if(breaks.begin(), breaks.end(),
                                  [&](const Break& b) { return b.update == update; });
  return found == breaks.end() ? nullptr : &*found;
}

// Between two updates, carried from both by odometry and scan matching.
PosePrior prior_between(const ScanCondenser::Scan& scan, const std::vector<Pose2>& poses,
                        const std::vector<ScanCondenser::Update>& updates,
                        const std::vector<Break>& breaks, const MotionModelOptions& motion_errors) {
  const std::size_t before = scan.updates - 1;
  const auto carried_from = [&](std::size_t update) {
    return gaussian_after(poses[update],
                          motion_between(updates[update].seen_from_robot, scan.seen_from_robot),
                          motion_errors);
  };
  if (before + 1 >= updates.size()) return carried_from(before);
  if (const Break* broken = break_before(before + 1, breaks)) {
    return carried_from(scan.time < broken->time ? before : before + 1);
  }
  return together(carried_from(before), carried_from(before + 1));
}

}  // namespace

SettledPath settled_path(const std::vector<Pose2>& poses,
                         const std::vector<ScanCondenser::Update>& updates,
                         const std::vector<ScanForWeighting>& scans,
                         const std::vector<Break>& breaks, const MotionModelOptions& motion_errors,
                         const SettlingOptions& options) {
  std::vector<PathStep> path;
  path.reserve(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Pose2 motion;
    if (i > 0) {
      // Across a break the filter alone says how the places lie to each other.
      motion = break_before(i, breaks) != nullptr
                   ? motion_between(poses[i - 1], poses[i])
                   : motion_between(updates[i - 1].seen_from_robot, updates[i].seen_from_robot);
    }
    path.push_back({poses[i], motion, &scans[i]});
  }
  return settled(std::move(path), motion_errors, options);
}

Trajectory with_scans_between(const SettledPath& path,
                              const std::vector<ScanCondenser::Update>& updates,
                              const std::vector<ScanCondenser::Scan>& scans,
                              const std::vector<KeptHits>& hits, const std::vector<Break>& breaks,
                              const MotionModelOptions& motion_errors,
                              const SettlingOptions& options) {
  Trajectory trajectory(scans.size());
  tbb::parallel_for(std::size_t{0}, scans.size(), [&](std::size_t i) {
    Pose2 pose = path.poses[scans[i].updates - 1];
    if (!scans[i].is_update) {
      std::vector<Eigen::Vector2d> points;
      points.reserve(hits[i].size());
      for (const Eigen::Vector2f& hit : hits[i]) points.push_back(hit.cast<double>());
      pose = settled_beside(points,
                            prior_between(scans[i], path.poses, updates, breaks, motion_errors),
                            path.map, options);
    }
    trajectory[i] = {scans[i].time, pose};
  });
  return trajectory;
}

}  // namespace mapbed
