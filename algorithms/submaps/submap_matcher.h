#pragma once

#include <optional>

#include <Eigen/Core>

#include "algorithms/motion/pose_prior.h"
#include "algorithms/submaps/submap.h"
#include "core/config/option.h"

namespace mapbed {

struct SubmapMatcherOptions {
  int search_points = 250;      // of a local map, in the search
  int compared_points = 400;    // of each, where two are compared
  double min_agreement = 0.75;  // of what both saw
  double min_overlap = 0.3;     // of their points both saw, at least
  // Both in windows above far_window, where a match must convince by itself.
  double min_agreement_far = 0.85;
  double min_overlap_far = 0.6;
  double far_window = 2.0;          // [m]
  double min_odds = 100.0;          // of the place found to any other one in the window
  double beam_weight = 0.25;        // fraction with which a point counts for these odds
  double rival_distance = 0.5;      // [m] from the place found: another one
  double rival_turn = 0.35;         // [rad] the same
  double least_sigma = 0.02;        // [m] of a match: what the cells allow
  double least_turn_sigma = 0.004;  // [rad]
  int max_blocks = 100'000;         // of poses that a search looks at
};

template <class Visitor>
void visit_fields(SubmapMatcherOptions& o, Visitor&& visit) {
  visit("search_points", o.search_points, between(10, 100'000),
        "points of a local map that are searched for in another");
  visit("compared_points", o.compared_points, between(10, 100'000),
        "points of each of two local maps that are compared");
  visit("min_agreement", o.min_agreement, kFraction,
        "fraction of what two local maps both saw that must agree");
  visit("min_overlap", o.min_overlap, kFraction,
        "fraction of their points that both must have seen");
  visit("min_agreement_far", o.min_agreement_far, kFraction,
        "as min_agreement, where they were searched for in a window above far_window");
  visit("min_overlap_far", o.min_overlap_far, kFraction, "as min_overlap, in such a window");
  visit("far_window", o.far_window, Unit::meter, kNotNegative,
        "where a match must convince by itself");
  visit("min_odds", o.min_odds, between(1.0, 1e12), "odds of the place found to any other one");
  visit("least_sigma", o.least_sigma, Unit::meter, kPositive, "sigma of a match at least");
  visit("least_turn_sigma", o.least_turn_sigma, Unit::radian, kPositive, "the same of its heading");
  visit("max_blocks", o.max_blocks, between(0, 10'000'000),
        "blocks of poses that a search looks at at most; 0: any number");
}

// How two local maps lie on each other at some pose, by what each saw of the other's surfaces, the
// negative information of 6.3.4 with it: a wall of one where the other looked through is as much
// against the pose as a wall that both have is for it. What only one of them could see says
// nothing.
struct Agreement {
  double matched = 0.0;       // points of either that lie on a surface of the other
  double contradicted = 0.0;  // that the other looked through, or saw a surface beside
  double unseen = 0.0;        // the rest

  double ratio() const {
    const double seen = matched + contradicted;
    return seen > 0.0 ? matched / seen : 0.0;
  }
  double overlap() const {
    const double all = matched + contradicted + unseen;
    return all > 0.0 ? (matched + contradicted) / all : 0.0;
  }
};
Agreement agreement(const Submap& target, const LikelihoodField& target_field, const Submap& query,
                    const LikelihoodField& query_field, const Pose2& target_from_query,
                    const SubmapMatcherOptions& options);

struct SubmapMatch {
  Pose2 target_from_query;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // (x, y, theta) in the frame of the query
  Agreement agreement;
  double log_likelihood = 0.0;  // of the query's points in the target's field
  bool is_unique = true;        // nowhere else in the window they fit nearly as well
  bool complete = true;         // false: the search was given up
};

// Whether is_unique is asked for, which takes a second search; else it is true where the first one
// was not given up.
enum class Rivals : int { searched, ignored };

// Where one local map lies in the frame of another, within a window about where it is predicted
// ([m] along both axes, [rad]), by branch and bound and a climb from there. None where they do not
// agree anywhere.
std::optional<SubmapMatch> match_submaps(const Submap& target, const SubmapField& target_field,
                                         const Submap& query, const SubmapField& query_field,
                                         const Pose2& predicted, double window, double turn_window,
                                         const SubmapMatcherOptions& options,
                                         Rivals rivals = Rivals::searched);

}  // namespace mapbed
