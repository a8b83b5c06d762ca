#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/association_tree.h"
#include "algorithms/grid/map_builder.h"
#include "bench/plot/plot.h"

namespace mapbed {

// What the newest local map saw, at its likelihood under the decisions of that moment and under
// those chosen in the end, over the time that it ended [s], as Figure 6.3: a wrong decision shows
// as a dip. `label` begins the subtitle.
Plot likelihood_plot(const AssociationTree& tree, const std::string& label = {});

// The revision in which most decisions were taken back; of several the one that gained most.
std::optional<AssociationTree::Revision> largest_revision(const AssociationTree& tree);

inline constexpr std::array<const char*, 2> kRevisionMaps = {"before_revision.png",
                                                             "after_revision.png"};

// Maps of the log up to the largest revision, as Figure 6.4, PNG images by their files' names. None
// where nothing was taken back.
std::vector<std::pair<std::string, std::string>> revision_maps(const AssociationTree& tree,
                                                               const SensorLog& log,
                                                               const MapOptions& options);

}  // namespace mapbed
