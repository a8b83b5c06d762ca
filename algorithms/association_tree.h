#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry/trajectory.h"
#include "core/time_interval.h"

namespace mapbed {

// The data associations that a lazy search looked at, chapter 6: which earlier local map shows the
// place that a new one shows, if any. A path from the root to a leaf decides it for each of them.
struct AssociationTree {
  struct Node {
    int parent = -1;      // in `nodes`, before this one; -1: the root, of the first local map
    int local_map = 0;    // that this decision is about
    int associated = -1;  // the earlier local map; -1: a new place
    // Of all that was seen up to this local map under the decisions up to here, up to a constant.
    double log_likelihood = 0.0;
    bool expanded = false;  // decisions about the next local map were looked at under this one
    double newest = 0.0;    // of log_likelihood, what this local map saw
  };
  // The most likely leaf after each local map.
  struct Choice {
    double time = 0.0;  // [s] when the local map ended
    std::size_t node = 0;
    double log_likelihood = 0.0;
    double newest = 0.0;  // the part that this local map has in it
  };
  // Decisions about the past that were taken back.
  struct Revision {
    double time = 0.0;                  // [s]
    int at = 0;                         // local map with which it was found out
    int since = 0;                      // the first local map whose decision changed
    int changed = 0;                    // decisions
    std::size_t before = 0, after = 0;  // leaves
    double log_likelihood_before = 0.0, log_likelihood_after = 0.0;  // with this local map
    Trajectory path_before, path_after;  // map_from_robot under both, up to this local map
  };
  std::vector<Node> nodes;
  std::vector<TimeInterval> local_maps;  // [s] when each was made
  std::vector<Choice> choices;
  std::vector<Revision> revisions;
  std::size_t chosen = 0;  // leaf
  int given_up = 0;        // local maps at which the search ended before it was sure
};

}  // namespace mapbed
