#pragma once

#include <string>
#include <vector>

#include "algorithms/grid/occupancy_map.h"
#include "bench/plot/map_picture.h"
#include "core/image/image.h"

namespace mapbed {

struct NamedMap {
  std::string name;  // above it; may be empty
  OccupancyMap map;
  DrawnPoints dynamic = {};  // drawn over it, as in picture_of()
};

// Several maps as one figure, all at the same scale whatever their resolutions are: row by row, in
// rows of as many as let them be largest; below, one scale bar and a legend. The maps of a row
// together, and those of a column, are `longest_side` pixels long at most.
RgbImage figure_of(const std::vector<NamedMap>& maps, int longest_side);

}  // namespace mapbed
