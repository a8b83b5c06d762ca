#include "algorithms/pose_graph/factor_pattern.h"

#include <algorithm>
#include <cstddef>

#include "algorithms/pose_graph/elimination_order.h"

namespace mapbed {

FactorPattern factor_pattern(int nodes, const std::vector<std::pair<int, int>>& pairs) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  FactorPattern pattern;
  pattern.places = elimination_places(nodes, pairs);
  pattern.nodes.resize(at(nodes));
  for (int node = 0; node < nodes; ++node) pattern.nodes[at(pattern.places[at(node)])] = node;

  pattern.below.resize(at(nodes));
  for (const auto& [a, b] : pairs) {
    const auto [first, last] = std::minmax(pattern.places[at(a)], pattern.places[at(b)]);
    if (first != last) pattern.below[at(first)].push_back(last);
  }
  // Who is eliminated links all that it was linked to: the first of them inherits the others.
  for (std::vector<int>& column : pattern.below) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    if (column.empty()) continue;
    std::vector<int>& parent = pattern.below[at(column.front())];
    parent.insert(parent.end(), column.begin() + 1, column.end());
  }
  return pattern;
}

}  // namespace mapbed
