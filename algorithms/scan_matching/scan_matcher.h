#pragma once

#include <optional>

#include "algorithms/field/likelihood_field.h"
#include "algorithms/motion/pose_prior.h"
#include "core/config/option.h"

namespace mapbed {

// Incremental scan matching, section 2.3: hill climbing on the logarithm of (2.19),
//
//   ln p(z | x, m) + ln p(x | u, x')
//
// from the predicted pose, one step or turn at a time; the step is halved when no neighbour is
// better. Finds the nearest optimum only. For large start errors see correlative_matcher.h.
struct ScanMatcherOptions {
  double first_step = 0.1;        // [m]
  double last_step = 0.02;        // [m] stop when the step would get smaller
  int polish_iterations = 4;      // of Gauss-Newton at the end
  double turn_per_meter = 0.5;    // [rad/m] couples the size of turns to that of steps
  double min_inlier_ratio = 0.4;  // a match that explains less of the scan is not trusted
};

template <class Visitor>
void visit_fields(ScanMatcherOptions& o, Visitor&& visit) {
  visit("first_step", o.first_step, Unit::meter, between(1e-4, 10.0), "first step of the search");
  visit("last_step", o.last_step, Unit::meter, between(1e-5, 10.0),
        "the search ends where the step gets smaller");
  visit("polish_iterations", o.polish_iterations, between(0, 1000),
        "Gauss-Newton iterations at the end");
  visit("turn_per_meter", o.turn_per_meter, Unit::radian_per_meter, between(1e-3, 100.0),
        "size of turns beside that of steps");
  visit("min_inlier_ratio", o.min_inlier_ratio, kFraction,
        "fraction of the scan that a trusted match explains");
}

struct ScanMatch {
  Pose2 map_from_robot;         // the prediction's mean where points_used is 0
  double log_posterior = 0.0;   // up to a constant, at map_from_robot
  double log_likelihood = 0.0;  // of the points alone
  double inlier_ratio = 0.0;  // 1: all points lie on the map, 0: none does; by mean log-likelihood
  int points_used = 0;
  bool trustworthy = false;             // false: the caller should keep the prediction
  bool contradicts_prediction = false;  // found without regard to it, as nothing near it fitted
  // Where the robot was looked for, where that is not where odometry's last step ends.
  std::optional<Pose2> other_prediction = {};
};

// `points` as made by to_field_points(…, map.resolution()).
ScanMatch match_scan(const FieldPoints& points, const LikelihoodField& map,
                     const PosePrior& prediction, const ScanMatcherOptions& options = {});

// The same, but the climb begins at `start` instead of the prediction's mean.
ScanMatch match_scan_from(const Pose2& start, const FieldPoints& points, const LikelihoodField& map,
                          const PosePrior& prediction, const ScanMatcherOptions& options = {});

// A match made finer by further points, that must not say how far along its line a surface goes:
// Gauss-Newton by what all of them say across their lines.
ScanMatch finer_across(const ScanMatch& match, const FieldPoints& points,
                       const LikelihoodField& map, const PosePrior& prediction,
                       const ScanMatcherOptions& options = {});

}  // namespace mapbed
