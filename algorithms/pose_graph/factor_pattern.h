#pragma once

#include <utility>
#include <vector>

namespace mapbed {

// Where the Cholesky factor L of a symmetric matrix over the nodes of a graph has entries.
struct FactorPattern {
  std::vector<int> nodes;               // at each place of the order of elimination
  std::vector<int> places;              // of each node
  std::vector<std::vector<int>> below;  // of each place: rows of L below its diagonal, ascending
};

// Of a matrix that has entries for the pairs, in the order of elimination_order.h.
FactorPattern factor_pattern(int nodes, const std::vector<std::pair<int, int>>& pairs);

}  // namespace mapbed
