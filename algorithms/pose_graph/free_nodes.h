#pragma once

#include <utility>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"

namespace mapbed {

// The nodes of a graph that are not held, numbered, and which of them constraints join.
struct FreeNodes {
  std::vector<int> numbers;  // of each node; -1: held
  int count = 0;
  std::vector<std::pair<int, int>> pairs;  // of numbers
  std::vector<int> pair_of_constraint;     // into `pairs`; -1: less than two free nodes

  template <class Pose>
  explicit FreeNodes(const PoseGraph<Pose>& graph) {
    for (const bool is_held : held_nodes(graph)) numbers.push_back(is_held ? -1 : count++);
    for (const PoseConstraint<Pose>& constraint : graph.constraints) {
      const int from = numbers[static_cast<std::size_t>(constraint.from)];
      const int to = numbers[static_cast<std::size_t>(constraint.to)];
      const bool joins_two = from >= 0 && to >= 0 && from != to;
      pair_of_constraint.push_back(joins_two ? static_cast<int>(pairs.size()) : -1);
      if (joins_two) pairs.emplace_back(from, to);
    }
  }
};

}  // namespace mapbed
