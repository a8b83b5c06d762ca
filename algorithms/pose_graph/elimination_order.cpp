#include "algorithms/pose_graph/elimination_order.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace mapbed {

std::vector<int> elimination_places(int nodes, const std::vector<std::pair<int, int>>& pairs) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * pairs.size() + static_cast<std::size_t>(nodes));
  for (int node = 0; node < nodes; ++node) entries.emplace_back(node, node, 1.0);
  for (const auto& [a, b] : pairs) {
    entries.emplace_back(a, b, 1.0);
    entries.emplace_back(b, a, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(nodes, nodes);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;  // place -> node
  Eigen::AMDOrdering<int>()(pattern, order);
  std::vector<int> places(static_cast<std::size_t>(nodes));
  for (int place = 0; place < nodes; ++place) {
    places[static_cast<std::size_t>(order.indices()[place])] = place;
  }
  return places;
}

}  // namespace mapbed
