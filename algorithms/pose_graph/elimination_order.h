#pragma once

#include <utility>
#include <vector>

namespace mapbed {

// At which place each node is eliminated, so that few entries of a factor fill in: approximate
// minimum degree (Amestoy, Davis, Duff 1996) over the graph of nodes that the pairs join.
std::vector<int> elimination_places(int nodes, const std::vector<std::pair<int, int>>& pairs);

}  // namespace mapbed
