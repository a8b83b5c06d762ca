#pragma once

#include <vector>

#include "algorithms/people/front_end/scan_sightings.h"
#include "core/geometry/trajectory.h"
#include "core/labels/beam_labels.h"

namespace mapbed {

// A box about somebody holds the wall beside him, too. Dynamic beams that end where, or a cell from
// where, more of the others end than go on, (2.15), met what stands there without him: they get
// this probability. `labels` has labels and `map_from_robot` a pose for each scan.
void keep_the_place(const std::vector<KeptScan>& scans, const Trajectory& map_from_robot,
                    float static_probability, BeamLabels& labels);

}  // namespace mapbed
