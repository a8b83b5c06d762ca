#include "algorithms/scan_matching/correlative_matcher.h"

#include <cmath>

#include "algorithms/scan_matching/correlative_search.h"
#include "algorithms/scan_matching/search_lattice.h"
#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

ScanMatch match_at(const Pose2& pose, const FieldPoints& points, const LikelihoodField& map,
                   const PosePrior& prediction, double min_inlier_ratio) {
  ScanMatch match{.map_from_robot = pose, .points_used = static_cast<int>(points.size())};
  match.log_likelihood = map.sum_log_at(points, pose);
  match.log_posterior = match.log_likelihood + prediction.log_at(pose);
  match.inlier_ratio =
      inlier_ratio(match.log_likelihood, double{map.outlier_log()} * points.total_weight());
  match.trustworthy = match.inlier_ratio >= min_inlier_ratio;
  return match;
}

}  // namespace

bool SearchLimits::exclude(const Pose2& pose) const {
  return away_from && mapbed::distance(pose, *away_from) <= distance &&
         std::abs(angle_difference(pose.theta, away_from->theta)) <= turn;
}

LimitedSearch best_match_within(const FieldPoints& points, const LikelihoodField& map,
                                const BoundPyramid& pyramid, const PosePrior& prediction,
                                const CorrelativeMatcherOptions& options,
                                const SearchLimits& limits) {
  CHECK(options.window >= 0.0 && options.turn_window >= 0.0 && !pyramid.levels.empty());
  if (points.size() == 0) return {};
  const SearchLattice lattice = lattice_of(points, map.resolution(), options);
  CHECK(lattice.shifts <= pyramid.max_shifts);
  const LatticeOptimum best = search_lattice(points, map, pyramid, prediction, lattice, limits);
  LimitedSearch result{.match = {}, .complete = best.complete};
  if (best.map_from_robot) {
    result.match =
        match_at(*best.map_from_robot, points, map, prediction, options.min_inlier_ratio);
  }
  return result;
}

ScanMatch match_correlative(const FieldPoints& points, const LikelihoodField& map,
                            const BoundPyramid& pyramid, const PosePrior& prediction,
                            const CorrelativeMatcherOptions& options) {
  return best_match_within(points, map, pyramid, prediction, options, {})
      .match.value_or(ScanMatch{.map_from_robot = prediction.mean});
}

ScanMatch match_exhaustive(const FieldPoints& points, const LikelihoodField& map,
                           const PosePrior& prediction, const CorrelativeMatcherOptions& options) {
  if (points.size() == 0) return {.map_from_robot = prediction.mean};
  const SearchLattice lattice = lattice_of(points, map.resolution(), options);
  Pose2 best;
  double best_value = -1e300;
  for (int turn = -lattice.turns; turn <= lattice.turns; ++turn) {
    for (int y = -lattice.shifts; y <= lattice.shifts; ++y) {
      for (int x = -lattice.shifts; x <= lattice.shifts; ++x) {
        const Pose2 pose = lattice.pose(prediction.mean, map.resolution(), turn, x, y);
        const double value = map.sum_log_at(points, pose) + prediction.log_at(pose);
        if (value <= best_value) continue;
        best_value = value;
        best = pose;
      }
    }
  }
  return match_at(best, points, map, prediction, options.min_inlier_ratio);
}

}  // namespace mapbed
