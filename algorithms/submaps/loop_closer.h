#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/submaps/loop_search.h"
#include "algorithms/submaps/submap_fields.h"
#include "algorithms/submaps/submap_matcher.h"

namespace mapbed {

// A local map that was found on another.
struct LoopMatch {
  int target = 0, query = 0;
  Pose2 target_from_query;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // in the frame of the query
  double window = 0.0;                                   // [m] that was searched
  double turn_window = 0.0;                              // [rad]
};

// As a constraint between the nodes of the local maps.
PoseConstraint<Pose2> constraint_between(const LoopMatch& match, int target_node, int query_node);

// Of a place anywhere in a window, that it lies within a region of this covariance and quantile of
// chi-square about another; 1 where the region is larger than the window. Of position and heading
// each by itself, which is not less than that of both.
double chance_within(const Eigen::Matrix3d& covariance, double quantile, double window,
                     double turn_window);

struct LoopCloserOptions {
  LoopSearchOptions search;
  SubmapMatcherOptions matching;
  double sure_window = 1.0;   // [m] a match in a smaller one needs no other to confirm it
  int confirmed_within = 10;  // local maps between two matches that confirm each other, at most
  // With which as many matches as confirm each other would agree by chance, at most.
  double confirming_chance = 0.05;
  double confidence = 0.99;  // of the region in which they must have the same place
};

template <class Visitor>
void visit_fields(LoopCloserOptions& o, Visitor&& visit) {
  visit("search", o.search, "which of them are, and where");
  visit("matching", o.matching, "when two of them show the same place");
  visit("sure_window", o.sure_window, Unit::meter, kNotNegative,
        "a match in a smaller window needs no other to confirm it");
  visit("confirmed_within", o.confirmed_within, between(1, 1'000'000),
        "local maps between two matches that confirm each other, at most");
  visit("confirming_chance", o.confirming_chance, between(1e-9, 1.0),
        "with which as many matches as confirm each other would agree by chance, at most");
  visit("confidence", o.confidence, between(0.5, 0.999999),
        "of the region in which two matches must have the same place");
}

// Finds where a path comes back to where it was: each new local map is looked for in those before
// it that may show the same. One match alone, in a window so large that it may be anywhere, may be
// a place that looks alike: it waits for others, of other local maps, that have its maps at the
// same place. Each of them would agree by chance as often as the region in which it must lie has a
// share in the window that was searched; when all together hardly would, all are believed.
class LoopCloser {
 public:
  LoopCloser(SubmapFields fields, const LoopCloserOptions& options);

  // The node of the graph whose frame the local map has.
  void add(Submap submap, int node);
  std::size_t size() const { return submaps_.size(); }

  // Matches of a local map that are to be believed now: its own, and those before that these
  // confirm. No pair is looked for twice.
  std::vector<LoopMatch> find(int query, const PoseGraph<Pose2>& graph,
                              const std::vector<double>& weights);

  PoseConstraint<Pose2> constraint_of(const LoopMatch& match) const;
  int waiting() const { return static_cast<int>(waiting_.size()); }

 private:
  std::vector<LoopMatch> matches_of(int query, const std::vector<LoopCandidate>& candidates);
  std::optional<double> chance_of_agreement(const LoopMatch& a, const LoopMatch& b,
                                            const PoseGraph<Pose2>& graph,
                                            const std::vector<double>& weights) const;
  int node_of(int submap) const { return nodes_[static_cast<std::size_t>(submap)]; }

  LoopCloserOptions options_;
  std::vector<Submap> submaps_;
  std::vector<int> nodes_;
  SubmapFields fields_;
  std::set<std::pair<int, int>> searched_;  // target, query
  std::vector<LoopMatch> waiting_;          // for another that confirms them
};

}  // namespace mapbed
