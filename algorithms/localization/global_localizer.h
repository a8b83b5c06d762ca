#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "algorithms/field/likelihood_field.h"
#include "algorithms/scan_matching/correlative_matcher.h"
#include "core/config/option.h"

namespace mapbed {

// How a robot that may have been carried away looks for itself in the map that it had before.
struct RelocalizationOptions {
  int max_updates = 50;            // after an interruption; 0: it never looks
  int scans = 5;                   // the newest ones, looked for together
  int max_points = 180;            // of them together
  double min_inlier_ratio = 0.65;  // of their points by the map, at the place found
  double min_odds = 100.0;         // of that place to any other one
  double beam_weight = 0.25;       // fraction with which a point counts for these odds
  double rival_distance = 0.5;     // [m] from the place found: another one
  double rival_turn = 0.35;        // [rad] the same
  int max_blocks = 200'000;        // of poses that a search looks at; about 0.05 s
  double beyond_path = 2.0;        // [m] outside the box about the path: where the robot may be
  LikelihoodFieldOptions field{.resolution = 0.1, .sigma = 0.1};
};

template <class Visitor>
void visit_fields(RelocalizationOptions& o, Visitor&& visit) {
  visit("max_updates", o.max_updates, between(0, 1'000'000),
        "updates after an interruption in which the whole map is searched; 0: none");
  visit("min_inlier_ratio", o.min_inlier_ratio, kFraction,
        "fraction of them that the map explains there");
  visit("min_odds", o.min_odds, between(1.0, 1e12), "odds of the place found to any other one");
}

// Finds scans in a whole map, all headings alike. A place is believed where two things hold:
//
// - The map explains the scans there, with the fraction that incremental matching asks of a match
//   against odometry: in a place that is not on the map, scans fit nowhere as well.
// - No other place comes near. Before looking all places are equally likely, so the odds of the
//   place found to another are those of the likelihoods, (p(z | x, m) / p(z | x', m))^beam_weight:
//   points err alike, so each counts with a fraction. A corridor that looks alike all along
//   therefore gives no answer.
//
// A search that takes too long is given up: where nothing stands out there is no answer.
//
// A place that is not on the map, but looks like one that is, is taken for it.
class GlobalLocalizer {
 public:
  // `path` is where the robot was while it made the map.
  GlobalLocalizer(const std::vector<SurfacePoint>& map, const std::vector<Pose2>& path,
                  const RelocalizationOptions& options);

  struct Answer {
    bool confirmed = false;             // where it is taken to be; no other place is clearly better
    std::optional<Pose2> relocated_to;  // map_from_robot
    bool plausible = false;             // the place where it is taken to be is possible at least
    bool complete = true;               // false: a search was given up
  };
  // Of points in the robot frame [m], the robot being taken to be at `here`. Neither here nor
  // elsewhere: it is nowhere on the map, or in one of several places.
  Answer find(const std::vector<Eigen::Vector2d>& points, const Pose2& here) const;
  // The same without a look at other places.
  Answer look_here(const std::vector<Eigen::Vector2d>& points, const Pose2& here) const;

  // Where points fit best at a place that others found; none where they do not fit there.
  std::optional<Pose2> matched_at(const Pose2& place,
                                  const std::vector<Eigen::Vector2d>& points) const;

  bool is_same_place(const Pose2& a, const Pose2& b) const;

 private:
  FieldPoints in_cells(const std::vector<Eigen::Vector2d>& points) const;
  RelocalizationOptions options_;
  double rival_margin_;  // of log-likelihoods
  Pose2 centre_;
  double window_ = 0.0;  // [m]
  LikelihoodField field_;
  BoundPyramid pyramid_;
};

}  // namespace mapbed
