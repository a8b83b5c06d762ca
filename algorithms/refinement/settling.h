#pragma once

#include <vector>

#include "algorithms/field/surface_likelihood.h"
#include "algorithms/motion/motion_model.h"
#include "core/config/option.h"

namespace mapbed {

// The path of a particle was drawn: each pose lies as far from where its scan fits best as the
// scan's posterior is wide, and the map is blurred by it. Settling takes this out of one path when
// it is asked for: all scans make a map, each is moved to its optimum in it, given where the
// motions from its neighbours on the path have it, and so again. Which place is which was decided
// by the filter and stays.
struct SettlingOptions {
  int rounds = 16;          // 0: the path as it was drawn
  double resolution = 0.1;  // [m] of the map
  double sigma = 0.08;      // [m] of an end point about the mapped surface
};

template <class Visitor>
void visit_fields(SettlingOptions& o, Visitor&& visit) {
  visit("rounds", o.rounds, at_least(0), "how often all scans are matched; 0: not at all");
  visit("resolution", o.resolution, Unit::meter, between(0.01, 2.0),
        "cells of the map they are matched in");
  visit("sigma", o.sigma, Unit::meter, kPositive, "spread of end points about the mapped surface");
}

// A place of the path, what was seen there, and the motion from the place before.
struct PathStep {
  Pose2 pose;  // map_from_robot
  Pose2 motion;
  const ScanForWeighting* scan = nullptr;
};

struct SettledPath {
  std::vector<Pose2> poses;
  SurfaceMap map;  // that the scans make from there
};
SettledPath settled(std::vector<PathStep> path, const MotionModelOptions& motion_errors,
                    const SettlingOptions& options);

// The optimum of a scan beside the path, matched by itself: it does not enter the map.
Pose2 settled_beside(const std::vector<Eigen::Vector2d>& hits, const PosePrior& prior,
                     const SurfaceMap& map, const SettlingOptions& options);

// What two beliefs about one pose say together, to first order in their difference.
PosePrior together(const PosePrior& a, const PosePrior& b);

}  // namespace mapbed
