#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/association_tree.h"

// What a lazy search of data associations looked at, chosen and took back, as JSON:
//
//   {"local_maps": [[from, to], ...],                           [s] stamps of the log
//    "nodes": [{"parent": 3, "local_map": 7, "associated": 2,   -1: none (the root; a new place)
//               "log_likelihood": -812.5, "expanded": true,
//               "newest": -20.5}, ...],
//    "chosen": 41,                                              number of a node, a leaf
//    "choices": [{"time": 12.5, "node": 9, "log_likelihood": -390.1, "newest": -41.7}, ...],
//    "revisions": [{"time": 80.2, "at": 17, "since": 12, "changed": 2, "before": 60, "after": 63,
//                   "log_likelihood_before": -950.0, "log_likelihood_after": -911.3,
//                   "decisions": [{"local_map": 12, "before": -1, "after": 1}, ...]}, ...],
//    "given_up": 0}
//
// as AssociationTree has it, but for the paths of revisions. A likelihood of zero has null for its
// logarithm. The `decisions` of a revision follow from the nodes: readers here leave them out.

namespace mapbed {

std::string associations_json(const AssociationTree& tree);

// Throws InputError for anything else: a node that comes before its parent, numbers of nodes or
// local maps that do not exist.
AssociationTree parse_associations(const std::string& name, std::string_view text);

// The nodes from the root to this one.
std::vector<std::size_t> path_to(const AssociationTree& tree, std::size_t node);

// Of a local map, what was decided before and after a revision.
struct ChangedDecision {
  int local_map = 0;
  int before = -1, after = -1;  // the earlier local map; -1: a new place
  friend bool operator==(const ChangedDecision&, const ChangedDecision&) = default;
};
std::vector<ChangedDecision> changed_decisions(const AssociationTree& tree,
                                               const AssociationTree::Revision& revision);

}  // namespace mapbed
