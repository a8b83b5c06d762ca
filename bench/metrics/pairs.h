#pragma once

#include <vector>

#include "bench/metrics/relations.h"
#include "core/geometry/trajectory.h"

namespace mapbed {

struct PairsOptions {
  double within = 2.0;  // [m] between two poses
  double after = 20.0;  // [m] of path between them, at least
};

// Relations between all poses of a reference that are near each other again after some path, for
// logs of which nobody measured any. Where the reference is a method's path, an error of these
// relations says how consistent with it an estimate is, not how true.
std::vector<Relation> pairs_of(const Trajectory& reference, const PairsOptions& options = {});

}  // namespace mapbed
