#pragma once

#include <span>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "algorithms/submaps/submap_fields.h"
#include "algorithms/submaps/submap_matcher.h"
#include "core/config/option.h"

namespace mapbed {

struct LoopSearchOptions {
  int candidates = 4;              // earlier local maps that a new one is matched with at most
  double sigmas = 3.0;             // of where it is believed, that are searched
  double least_window = 0.5;       // [m]
  double largest_window = 15.0;    // [m]
  double least_turn_window = 0.2;  // [rad]
  double distance = 4.0;           // [m] between two scans that see the same place
  int apart = 2;                   // local maps between two that are matched, at least
};

template <class Visitor>
void visit_fields(LoopSearchOptions& o, Visitor&& visit) {
  visit("candidates", o.candidates, between(0, 10'000),
        "earlier local maps that a new one is matched with at most");
  visit("sigmas", o.sigmas, between(0.1, 100.0), "of where a local map may be, that are searched");
  visit("least_window", o.least_window, Unit::meter, kPositive,
        "about where it is believed, searched at least");
  visit("largest_window", o.largest_window, Unit::meter, kPositive, "the same at most");
  visit("least_turn_window", o.least_turn_window, Unit::radian, kPositive,
        "turns that are searched at least");
  visit("distance", o.distance, Unit::meter, kPositive,
        "between two scans that see the same place, at most");
}

// A local map that another may lie on, and where it is looked for there.
struct LoopCandidate {
  int target = 0;
  Pose2 target_from_query;   // as it is believed
  double window = 0.0;       // [m]
  double turn_window = 0.0;  // [rad]
};

// Where the local maps are: one node of the graph each.
struct SubmapNodes {
  std::span<const Submap> submaps;
  std::span<const int> nodes;
};

// Which of the local maps may show what the query shows, by how well its pose is known as seen from
// each of them: the likeliest to overlap first, none that stands next to another on the path.
std::vector<LoopCandidate> loop_candidates(const SubmapNodes& submaps, int query,
                                           const PoseGraph<Pose2>& graph,
                                           const std::vector<double>& weights,
                                           const LoopSearchOptions& options);

}  // namespace mapbed
