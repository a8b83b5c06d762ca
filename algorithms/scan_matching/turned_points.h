#pragma once

#include <vector>

#include "algorithms/field/bound_pyramid.h"
#include "algorithms/field/bound_sums.h"
#include "algorithms/field/field_points.h"
#include "algorithms/field/processor.h"
#include "algorithms/scan_matching/search_lattice.h"
#include "core/geometry/pose2.h"

namespace mapbed {

// The points of a scan at the middle of a group of turns, in cells of the map: shifted by a block's
// shifts and turned by the group's turns, each falls into the cells from here up to what its level
// covers. Points that no shift brings into the map are left out.
struct TurnedPoints {
  PointsInCells cells;
  std::vector<float> weights;  // of the same points, where they have any
};

// 2^group_bits neighbouring turns that are bounded together.
struct TurnGroup {
  int first = 0;  // turn of the lattice
  int bits = 0;
  int level = 0;  // of the blocks of shifts: 2^level x 2^level
};

// Turns points about a pose, in groups of up to 2^most_bits turns.
class PointTurner {
 public:
  PointTurner(const FieldPoints& points, const Pose2& center, double resolution,
              const BoundPyramid& pyramid, const SearchLattice& lattice, int most_bits,
              Processor processor = this_processor());

  TurnedPoints turned(const TurnGroup& group) const;

 private:
  std::uint8_t level_over(int cells) const;

  const FieldPoints& points_;
  const BoundPyramid& pyramid_;
  SearchLattice lattice_;
  Processor processor_;
  double theta_;                   // [rad] of the pose
  double x_, y_;                   // [cells] of the pose
  std::vector<double> distances_;  // [cells] of the points from the robot, where that is needed
};

}  // namespace mapbed
