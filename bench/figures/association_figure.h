#pragma once

#include <string>

#include "algorithms/association_tree.h"
#include "bench/plot/plot.h"

namespace mapbed {

// The tree of data associations over the numbers of the local maps, as Figure 6.1: the decisions
// chosen in the end, those that were chosen once and taken back, and what else was looked at. Each
// stands at its log-likelihood less that of the decisions chosen in the end, up to the same local
// map: what looked better for a while lies above zero, and falls below it where it is taken back.
// Alternatives that lie below all that was ever chosen are left out. `label` begins the subtitle.
Plot association_plot(const AssociationTree& tree, const std::string& label = {});

}  // namespace mapbed
