#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "core/geometry/pose2.h"

namespace mapbed {

// The past of a particle, one node an update, newest first. Particles share the nodes that they
// have in common, so memory grows with distinct ancestry and not with particles times updates.
struct HistoryNode {
  Pose2 pose;  // map_from_robot
  std::size_t update = 0;
  std::shared_ptr<HistoryNode> parent;

  HistoryNode(const Pose2& at, std::size_t number, std::shared_ptr<HistoryNode> before)
      : pose(at), update(number), parent(std::move(before)) {}
  HistoryNode(const HistoryNode&) = delete;
  HistoryNode& operator=(const HistoryNode&) = delete;

  // One after the other: a chain of a million nodes must not need a million nested calls.
  ~HistoryNode() {
    std::shared_ptr<HistoryNode> node = std::move(parent);
    while (node != nullptr && node.use_count() == 1) node = std::exchange(node->parent, nullptr);
  }
};

}  // namespace mapbed
