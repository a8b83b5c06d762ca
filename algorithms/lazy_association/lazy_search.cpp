#include "algorithms/lazy_association/lazy_search.h"

#include <algorithm>

#include "core/check.h"

namespace mapbed {

void LazySearch::start(const Outcome& first) {
  CHECK(tree_.nodes.empty());
  tree_.nodes.push_back({.log_likelihood = first.log_likelihood, .newest = first.newest});
  frontier_.push_back(0);
  most_.push_back({});
}

std::vector<std::size_t> LazySearch::path_to(std::size_t node) const {
  std::vector<std::size_t> path;
  for (int at = static_cast<int>(node); at >= 0;
       at = tree_.nodes[static_cast<std::size_t>(at)].parent) {
    path.push_back(static_cast<std::size_t>(at));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

void LazySearch::expand_node(std::size_t node, const Expand& expand) {
  const std::vector<Outcome> outcomes = expand(node);
  CHECK(!outcomes.empty());
  const int local_map = tree_.nodes[node].local_map + 1;
  const auto level = static_cast<std::size_t>(local_map);
  for (const Outcome& outcome : outcomes) {
    const double added = outcome.log_likelihood - tree_.nodes[node].log_likelihood;
    if (!most_[level].is_bound) most_[level].value = std::max(most_[level].value, added);
    frontier_.push_back(tree_.nodes.size());
    tree_.nodes.push_back({.parent = static_cast<int>(node),
                           .local_map = local_map,
                           .associated = outcome.associated,
                           .log_likelihood = outcome.log_likelihood,
                           .newest = outcome.newest});
  }
  tree_.nodes[node].expanded = true;
  std::erase(frontier_, node);
}

double LazySearch::bound(std::size_t node) const {
  double bound = tree_.nodes[node].log_likelihood;
  for (auto level = static_cast<std::size_t>(tree_.nodes[node].local_map) + 1; level < most_.size();
       ++level) {
    bound += most_[level].value;
  }
  return bound;
}

// Of several equal ones the deepest: it is nearer to a leaf.
std::size_t LazySearch::best_of_frontier() const {
  return *std::max_element(frontier_.begin(), frontier_.end(), [&](std::size_t a, std::size_t b) {
    const double of_a = bound(a), of_b = bound(b);
    if (of_a != of_b) return of_a < of_b;
    return tree_.nodes[a].local_map < tree_.nodes[b].local_map;
  });
}

void LazySearch::advance(double time, const Expand& expand, const Most& most) {
  CHECK(!tree_.nodes.empty());
  most_.push_back(most);
  const int newest = static_cast<int>(most_.size()) - 1;
  const std::size_t before = tree_.chosen;
  // As incremental maximum likelihood does.
  expand_node(before, expand);
  int expansions = 1;
  std::size_t best = best_of_frontier();
  for (; tree_.nodes[best].local_map != newest; best = best_of_frontier()) {
    if (expansions++ == options_.max_expansions) break;
    expand_node(best, expand);
  }
  if (tree_.nodes[best].local_map != newest) {
    ++tree_.given_up;
    best = *std::max_element(frontier_.begin(), frontier_.end(), [&](std::size_t a, std::size_t b) {
      const AssociationTree::Node &of_a = tree_.nodes[a], &of_b = tree_.nodes[b];
      if ((of_a.local_map == newest) != (of_b.local_map == newest)) {
        return of_b.local_map == newest;
      }
      return of_a.log_likelihood < of_b.log_likelihood;
    });
  }
  tree_.chosen = best;
  tree_.choices.push_back({time, best, tree_.nodes[best].log_likelihood, tree_.nodes[best].newest});
  note_revision(time, before);
  drop_least_likely();
}

void LazySearch::note_revision(double time, std::size_t before) {
  const std::size_t after = tree_.chosen;
  if (tree_.nodes[after].parent == static_cast<int>(before)) return;
  const std::vector<std::size_t> old_path = path_to(before), new_path = path_to(after);
  AssociationTree::Revision revision{.time = time,
                                     .at = tree_.nodes[after].local_map,
                                     .since = 0,
                                     .changed = 0,
                                     .before = before,
                                     .after = after};
  for (std::size_t level = 0; level < old_path.size(); ++level) {
    if (old_path[level] == new_path[level]) continue;
    if (revision.changed == 0) revision.since = static_cast<int>(level);
    const AssociationTree::Node &was = tree_.nodes[old_path[level]],
                                &is = tree_.nodes[new_path[level]];
    if (was.associated != is.associated) ++revision.changed;
  }
  // With the newest local map, both.
  revision.log_likelihood_after = tree_.nodes[after].log_likelihood;
  bool found = false;
  for (std::size_t node = before + 1; node < tree_.nodes.size(); ++node) {
    if (tree_.nodes[node].parent != static_cast<int>(before)) continue;
    const double value = tree_.nodes[node].log_likelihood;
    if (!found || value > revision.log_likelihood_before) {
      revision.log_likelihood_before = value;
      revision.before = node;
    }
    found = true;
  }
  tree_.revisions.push_back(revision);
}

void LazySearch::drop_least_likely() {
  const auto kept = static_cast<std::size_t>(options_.max_frontier);
  if (frontier_.size() <= kept) return;
  std::stable_sort(frontier_.begin(), frontier_.end(),
                   [&](std::size_t a, std::size_t b) { return bound(a) > bound(b); });
  const auto dropped = std::find(frontier_.begin() + static_cast<std::ptrdiff_t>(kept),
                                 frontier_.end(), tree_.chosen);
  if (dropped != frontier_.end()) std::iter_swap(dropped, frontier_.begin());
  frontier_.resize(kept);
}

}  // namespace mapbed
