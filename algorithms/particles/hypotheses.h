#pragma once

#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/particles/history.h"

namespace mapbed {

// What the particles' pasts have in common. Each particle is told by its newest node; `updates` has
// one entry for each update so far, the ancestors not counted yet.

// The poses of one past, by update.
std::vector<Pose2> path_of(const HistoryNode& newest);

std::vector<Diversity> diversity_of(const std::vector<const HistoryNode*>& particles,
                                    std::vector<Diversity> updates);

// All pasts, each pose once.
std::vector<Trajectory> branches_of(const std::vector<const HistoryNode*>& particles,
                                    const std::vector<Diversity>& updates);

}  // namespace mapbed
