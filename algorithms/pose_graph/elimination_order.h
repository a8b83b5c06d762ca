#pragma once

#include <utility>
#include <vector>

namespace mapbed {

// At which place each node is eliminated, so that few entries of a factor fill in: approximate
// minimum degree (Amestoy, Davis, Duff 1996) over the graph of nodes that the pairs join.
std::vector<int> elimination_places(int nodes, const std::vector<std::pair<int, int>>& pairs);

// The column that each column of a factor is added to first: the row of its first entry below the
// diagonal (Liu 1986); -1: none. Pairs are of places, in either order.
std::vector<int> elimination_tree(int places, const std::vector<std::pair<int, int>>& pairs);

// A new place for each, so that those below a node of the tree stand right before it.
std::vector<int> postorder(const std::vector<int>& tree);

}  // namespace mapbed
