#pragma once

#include <string>
#include <vector>

#include "core/geometry/trajectory.h"

namespace mapbed {

struct RelationsOptions {
  double shortest = 1.0;  // [m] of path between the poses of neighbouring relations
  double longest = 20.0;  // [m] of path that one relation spans
};

// True relative displacements between poses of a path, in the format of the relations metric
// (Kümmerle et al. 2009): one a line, `t1 t2 x y z roll pitch yaw`, the second pose in the frame of
// the first. Between poses `shortest` apart along the path, and between such that are close again
// after a loop.
std::string relations_text(const Trajectory& truth, const RelationsOptions& options = {});

}  // namespace mapbed
