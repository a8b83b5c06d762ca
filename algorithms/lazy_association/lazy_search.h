#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "algorithms/association_tree.h"
#include "core/config/option.h"

namespace mapbed {

struct LazySearchOptions {
  int max_expansions = 12;  // for each new local map
  int max_frontier = 200;   // hypotheses that are kept
};

template <class Visitor>
void visit_fields(LazySearchOptions& o, Visitor&& visit) {
  visit("max_expansions", o.max_expansions, between(1, 1'000'000),
        "hypotheses that are looked at again for each new local map, at most");
  visit("max_frontier", o.max_frontier, between(1, 1'000'000),
        "hypotheses that are kept, the most likely ones");
}

// The search of section 6.3.1, over trees whose levels are local maps and whose branches are
// decisions about them. The most likely leaf is chosen; all others stay on the frontier. With each
// new local map frontier nodes are expanded as long as one of them may still lead to a more likely
// leaf than the best one, however far back it lies.
//
// A node d levels above the leaves may lead to a leaf of at most
//
//   log_likelihood(node) + m_1 + ... + m_d,
//
// m_k being the most that the local map of that level can add to any hypothesis. Where the caller
// knows such bounds, the leaf is the most likely of all (Hart, Nilsson, Raphael 1968): when it is
// chosen no other node has a larger bound, and each leaf lies below some node of the frontier whose
// bound is not less than its likelihood. With m_k = 0, which holds for scores that are never
// positive, it is nearly breadth-first. Where the caller only expects that much, m_k grows with the
// most that the local map added to a hypothesis that was looked at: a heuristic.
class LazySearch {
 public:
  explicit LazySearch(const LazySearchOptions& options) : options_(options) {}

  struct Outcome {
    int associated = -1;  // as in AssociationTree::Node
    double log_likelihood = 0.0;
    double newest = 0.0;  // of it, what the newest local map has in it
  };
  // All decisions about the next local map under those up to a node, at least one. The nodes that
  // they become are numbered on from all before, in their order.
  using Expand = std::function<std::vector<Outcome>(std::size_t node)>;

  void start(const Outcome& first);  // the root: of the first local map
  // What a local map can add.
  struct Most {
    double value = 0.0;
    bool is_bound = true;  // false: it is expected only
  };
  // The next local map, that ended at `time` [s].
  void advance(double time, const Expand& expand, const Most& most);

  bool empty() const { return tree_.nodes.empty(); }
  std::size_t chosen() const { return tree_.chosen; }
  std::vector<std::size_t> path_to(std::size_t node) const;  // from the root
  const AssociationTree& tree() const { return tree_; }

 private:
  void expand_node(std::size_t node, const Expand& expand);
  double bound(std::size_t node) const;
  std::size_t best_of_frontier() const;
  void drop_least_likely();
  void note_revision(double time, std::size_t before);

  LazySearchOptions options_;
  AssociationTree tree_;
  std::vector<std::size_t> frontier_;  // nodes that were not expanded
  std::vector<Most> most_;             // by local map
};

}  // namespace mapbed
