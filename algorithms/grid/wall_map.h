#pragma once

#include "algorithms/grid/map_builder.h"
#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// The map as those want it who drive by it: occupied, free or unknown. A counting cell is the
// fraction of beams that it reflects; of a wall seen at a grazing angle nearly all beams that touch
// a cell go on to the next one, so that thresholds on that fraction leave holes.
//
// Here each scan looks at a cell once. It is evidence for a surface where the surface lies that the
// scan saw, between neighbouring hits on one wall too; it is evidence against one where beams went
// through and no surface of that scan is there, but for the last stretch of a beam that ends on a
// surface at a grazing angle, as far as it runs within a cell of it. A beam without return clears
// its path up to the first surface that other beams found, for dark walls and grazing ones return
// nothing. Odds add up over scans, with 0.7 and 0.4 for a look (Hornung et al., OctoMap, 2013), to
// p:
//
//   occupied, 1     p above 0.65
//   free, 0         p below 0.196, or no scan ever saw a surface there
//   unknown         else
//
// Takes scans, poses, resolution, limits of beams and labels as build_map() does, and throws as it
// does.
OccupancyMap wall_map(const SensorLog& log, const Trajectory& map_from_robot,
                      const MapOptions& options = {}, std::span<const ScanLabels> labels = {});

}  // namespace mapbed
