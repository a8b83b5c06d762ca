#include "algorithms/pose_graph/elimination_order.h"

#include <algorithm>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace mapbed {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

std::vector<int> elimination_places(int nodes, const std::vector<std::pair<int, int>>& pairs) {
  std::vector<Eigen::Triplet<char>> entries;
  entries.reserve(2 * pairs.size() + index(nodes));
  for (int node = 0; node < nodes; ++node) entries.emplace_back(node, node, char{1});
  for (const auto& [a, b] : pairs) {
    entries.emplace_back(a, b, char{1});
    entries.emplace_back(b, a, char{1});
  }
  Eigen::SparseMatrix<char> pattern(nodes, nodes);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;  // place -> node
  Eigen::internal::minimum_degree_ordering(pattern, order);
  std::vector<int> places(index(nodes));
  for (int place = 0; place < nodes; ++place) places[index(order.indices()[place])] = place;
  return places;
}

std::vector<int> elimination_tree(int places, const std::vector<std::pair<int, int>>& pairs) {
  std::vector<std::vector<int>> earlier(index(places));  // in each row
  for (const auto& [a, b] : pairs) {
    if (a != b) earlier[index(std::max(a, b))].push_back(std::min(a, b));
  }
  std::vector<int> tree(index(places), -1);
  std::vector<int> shortcut(index(places), -1);  // some node further up
  for (int row = 0; row < places; ++row) {
    for (int column : earlier[index(row)]) {
      while (column != -1 && column < row) {
        const int next = shortcut[index(column)];
        shortcut[index(column)] = row;
        if (next == -1) tree[index(column)] = row;
        column = next;
      }
    }
  }
  return tree;
}

std::vector<int> postorder(const std::vector<int>& tree) {
  const int count = static_cast<int>(tree.size());
  std::vector<int> first_child(tree.size(), -1), next_sibling(tree.size(), -1);
  std::vector<int> open;  // nodes whose subtree is not done
  for (int node = count - 1; node >= 0; --node) {
    const int parent = tree[index(node)];
    if (parent == -1) {
      open.push_back(node);
    } else {
      next_sibling[index(node)] = first_child[index(parent)];
      first_child[index(parent)] = node;
    }
  }
  std::vector<int> places(tree.size());
  int place = 0;
  while (!open.empty()) {
    const int node = open.back();
    const int child = first_child[index(node)];
    if (child == -1) {
      places[index(node)] = place++;
      open.pop_back();
    } else {
      first_child[index(node)] = next_sibling[index(child)];
      open.push_back(child);
    }
  }
  return places;
}

}  // namespace mapbed
