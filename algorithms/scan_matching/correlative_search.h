#pragma once

#include <optional>

#include "algorithms/field/bound_pyramid.h"
#include "algorithms/field/likelihood_field.h"
#include "algorithms/motion/pose_prior.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "algorithms/scan_matching/search_lattice.h"

namespace mapbed {

struct LatticeOptimum {
  std::optional<Pose2> map_from_robot;  // none: no pose of the lattice is within the limits
  bool complete = true;                 // false: given up after max_blocks
};

// The best pose of a lattice within limits, by branch and bound: a block of shifts, and in large
// windows of turns too, is split only where its bound lies above the best pose so far.
LatticeOptimum search_lattice(const FieldPoints& points, const LikelihoodField& map,
                              const BoundPyramid& pyramid, const PosePrior& prediction,
                              const SearchLattice& lattice, const SearchLimits& limits);

}  // namespace mapbed
