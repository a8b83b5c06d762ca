#include "algorithms/pose_graph/pose_graph.h"

#include <algorithm>
#include <numeric>

namespace mapbed {
namespace {

// Sets that grow together; the first element of a set stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int first_of(int element) {
    while (parent(element) != element) {
      parent(element) = parent(parent(element));
      element = parent(element);
    }
    return element;
  }

  void unite(int a, int b) {
    a = first_of(a);
    b = first_of(b);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& parent(int element) { return parent_[static_cast<std::size_t>(element)]; }

  std::vector<int> parent_;
};

}  // namespace

std::vector<int> components_of(int nodes, const std::vector<std::pair<int, int>>& joined) {
  DisjointSets sets(static_cast<std::size_t>(nodes));
  for (const auto& [a, b] : joined) sets.unite(a, b);
  std::vector<int> component(static_cast<std::size_t>(nodes));
  int count = 0;
  for (std::size_t node = 0; node < component.size(); ++node) {
    const auto first = static_cast<std::size_t>(sets.first_of(static_cast<int>(node)));
    component[node] = first == node ? count++ : component[first];
  }
  return component;
}

template <class Pose>
std::vector<int> components_of(const PoseGraph<Pose>& graph) {
  std::vector<std::pair<int, int>> joined;
  joined.reserve(graph.constraints.size());
  for (const auto& constraint : graph.constraints) {
    joined.emplace_back(constraint.from, constraint.to);
  }
  return components_of(static_cast<int>(graph.nodes.size()), joined);
}

template <class Pose>
std::vector<bool> held_nodes(const PoseGraph<Pose>& graph) {
  const std::vector<int> component = components_of(graph);
  std::vector<bool> held(graph.nodes.size(), false);
  std::vector<bool> has_one(graph.nodes.size(), false);
  const auto hold = [&](std::size_t node) {
    held[node] = true;
    has_one[static_cast<std::size_t>(component[node])] = true;
  };
  for (const int node : graph.held) hold(static_cast<std::size_t>(node));
  for (std::size_t node = 0; node < held.size(); ++node) {
    if (!has_one[static_cast<std::size_t>(component[node])]) hold(node);
  }
  return held;
}

template std::vector<int> components_of(const PoseGraph<Pose2>&);
template std::vector<int> components_of(const PoseGraph<Pose3>&);
template std::vector<bool> held_nodes(const PoseGraph<Pose2>&);
template std::vector<bool> held_nodes(const PoseGraph<Pose3>&);

}  // namespace mapbed
