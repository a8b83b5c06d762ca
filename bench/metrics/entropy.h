#pragma once

#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// [bit] the mean over the known cells of -p log2 p - (1 - p) log2(1 - p): 0 for a map that is sure
// of every cell it has seen, 1 for one that is sure of none. NaN where nothing is known. Negated it
// is the map's sharpness: scans at wrong poses contradict each other, and the cells turn grey.
double mean_entropy(const OccupancyMap& map);

}  // namespace mapbed
