#pragma once

#include "algorithms/field/field_points.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// The lattice that is searched: turns about the prediction, then shifts by whole cells.
struct SearchLattice {
  int shifts = 0;          // -shifts … shifts [cells]
  int turns = 0;           // -turns … turns
  double turn_step = 0.0;  // [rad]

  // map_from_robot of a turn and shifts about `center`; `resolution` is the side of a cell [m].
  Pose2 pose(const Pose2& center, double resolution, int turn, int x, int y) const;
};

SearchLattice lattice_of(const FieldPoints& points, double resolution,
                         const CorrelativeMatcherOptions& options);

}  // namespace mapbed
