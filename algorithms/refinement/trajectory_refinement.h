#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/motion/track.h"
#include "core/config/option.h"

namespace mapbed {

// The path of a particle was drawn: each pose lies as far from where its scan fits best as the
// scan's posterior is wide, and the map is blurred by it. Trajectory refinement takes this out of
// one path when it is asked for: all scans make a map, each is moved to its optimum in it, given
// where the motions from its neighbours on the path have it, and so again. Which place is which was
// decided before and stays.
struct RefinementOptions {
  bool enabled = false;
  int rounds = 16;
  double resolution = 0.1;  // [m] of the map
  double sigma = 0.08;      // [m] of an end point about the mapped surface
};

template <class Visitor>
void visit_fields(RefinementOptions& o, Visitor&& visit) {
  visit(
      "enabled", o.enabled,
      "match all scans of the path with the map that they make; 'mapbed map' does so unless told");
  visit("rounds", o.rounds, between(0, 1000), "how often all scans are matched");
  visit("resolution", o.resolution, Unit::meter, between(0.01, 2.0),
        "cells of the map they are matched in");
  visit("sigma", o.sigma, Unit::meter, between(0.001, 2.0),
        "sigma of end points about the mapped surface");
}

// A place of the path, what was seen there, and the motion from the place before.
struct PathStep {
  Pose2 pose;  // map_from_robot
  Pose2 motion;
  const ScanForWeighting* scan = nullptr;
};

struct RefinedPath {
  std::vector<Pose2> poses;
  SurfaceMap map;  // that the scans make from there
};
RefinedPath refined(std::vector<PathStep> path, const MotionModelOptions& motion_errors,
                    const RefinementOptions& options);

// The same of the anchors of a track, each with its scan.
RefinedPath refined(const std::vector<Pose2>& anchors, const std::vector<ScanForWeighting>& scans,
                    const Track& track, const RefinementOptions& options);

// End points of a scan that is kept to be matched beside the path [m], in the robot frame.
using KeptHits = std::vector<Eigen::Vector2f>;

// The poses of all scans: those between anchors are matched with the map of the path, from where
// the track carries them. `hits` has an entry for each scan; those of anchors are not read.
Trajectory refined_trajectory(const RefinedPath& path, const Track& track,
                              const std::vector<KeptHits>& hits, const RefinementOptions& options);

// The optimum of a scan beside the path, matched by itself: it does not enter the map.
Pose2 matched_beside(const std::vector<Eigen::Vector2d>& hits, const PosePrior& prior,
                     const SurfaceMap& map, const RefinementOptions& options);

}  // namespace mapbed
