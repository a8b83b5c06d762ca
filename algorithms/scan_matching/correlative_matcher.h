#pragma once

#include <optional>
#include <vector>

#include "algorithms/field/bound_pyramid.h"
#include "algorithms/field/likelihood_field.h"
#include "algorithms/motion/pose_prior.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "core/config/option.h"

namespace mapbed {

// Correlative scan matching (Olson 2009) with branch and bound over translations (Hess et al.
// 2016): the best pose on a lattice of turns and of shifts by whole cells about the prediction, by
// the score that hill climbing uses (2.19). It is the global optimum on that lattice; climb from it
// for the rest.
struct CorrelativeMatcherOptions {
  double window = 0.6;            // [m] shifts of up to this, along both axes of the map
  double turn_window = 0.6;       // [rad] turns of up to this
  double turn_step = 0.0;         // [rad] 0: the far points of the scan move by about one cell
  double min_inlier_ratio = 0.4;  // a match that explains less of the scan is not trusted
};

template <class Visitor>
void visit_fields(CorrelativeMatcherOptions& o, Visitor&& visit) {
  visit("window", o.window, Unit::meter, between(0.0, 100.0),
        "shifts of up to this, along both axes of the map");
  visit("turn_window", o.turn_window, Unit::radian, between(0.0, 10.0), "turns of up to this");
  visit("turn_step", o.turn_step, Unit::radian, between(0.0, 10.0),
        "between tried turns; 0: far points move by one cell");
  visit("min_inlier_ratio", o.min_inlier_ratio, kFraction,
        "fraction of the scan that a trusted match explains");
}

// `points` as made by to_field_points(…, map.resolution()); `pyramid` of the same map.
ScanMatch match_correlative(const FieldPoints& points, const LikelihoodField& map,
                            const BoundPyramid& pyramid, const PosePrior& prediction,
                            const CorrelativeMatcherOptions& options = {});

// Which poses a search may answer with.
struct SearchLimits {
  double above = -1e300;           // of a larger log-posterior than this only
  double enough = 1e300;           // the first one that reaches this will do
  std::optional<Pose2> away_from;  // only farther from this pose than
  double distance = 0.0;           // [m] or
  double turn = 0.0;               // [rad]
  // Blocks of poses that are bounded at most; 0: as many as it takes. Where nothing stands out
  // nearly every pose must be looked at, which takes minutes in a large map.
  std::size_t max_blocks = 0;

  bool exclude(const Pose2& pose) const;  // too near to `away_from`
};

// The same within limits. The higher `above`, the faster.
struct LimitedSearch {
  std::optional<ScanMatch> match;  // none: no pose of the lattice is within the limits
  bool complete = true;            // false: given up after max_blocks
};
LimitedSearch best_match_within(const FieldPoints& points, const LikelihoodField& map,
                                const BoundPyramid& pyramid, const PosePrior& prediction,
                                const CorrelativeMatcherOptions& options,
                                const SearchLimits& limits);

// The plain version: every pose of the lattice. For tests.
ScanMatch match_exhaustive(const FieldPoints& points, const LikelihoodField& map,
                           const PosePrior& prediction,
                           const CorrelativeMatcherOptions& options = {});

}  // namespace mapbed
