#include "algorithms/particles/hypotheses.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace mapbed {

std::vector<Pose2> path_of(const HistoryNode& newest) {
  std::vector<Pose2> path(newest.update + 1);
  for (const HistoryNode* node = &newest; node != nullptr; node = node->parent.get()) {
    path[node->update] = node->pose;
  }
  return path;
}

std::vector<Diversity> diversity_of(const std::vector<const HistoryNode*>& particles,
                                    std::vector<Diversity> updates) {
  std::unordered_set<const HistoryNode*> generation(particles.begin(), particles.end());
  for (std::size_t i = updates.size(); i-- > 0;) {
    updates[i].distinct_ancestors = static_cast<int>(generation.size());
    std::unordered_set<const HistoryNode*> before;
    for (const HistoryNode* node : generation) before.insert(node->parent.get());
    generation = std::move(before);
  }
  return updates;
}

std::vector<Trajectory> branches_of(const std::vector<const HistoryNode*>& particles,
                                    const std::vector<Diversity>& updates) {
  std::vector<Trajectory> branches;
  std::unordered_set<const HistoryNode*> drawn;
  for (const HistoryNode* newest : particles) {
    Trajectory branch;
    for (const HistoryNode* node = newest; node != nullptr; node = node->parent.get()) {
      branch.push_back({updates[node->update].time, node->pose});
      if (!drawn.insert(node).second) break;
    }
    std::reverse(branch.begin(), branch.end());
    if (branch.size() > 1) branches.push_back(std::move(branch));
  }
  return branches;
}

}  // namespace mapbed
