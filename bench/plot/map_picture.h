#pragma once

#include <string>
#include <vector>

#include "algorithms/grid/occupancy_map.h"
#include "core/geometry/trajectory.h"
#include "core/image/image.h"

namespace mapbed {

struct DrawnPath {
  std::string name;  // in the legend
  Trajectory map_from_robot;
};

struct PictureOptions {
  int longest_side = 1600;  // [pixels] of the map, at most; a cell is a whole number of them, or
                            // where there are more cells, a pixel is a whole number of cells
};

// A map for people, as it could stand in a paper: free is white, occupied black, unknown grey-blue;
// the far ends of the few beams that went out of a window are left out;
// the paths in colours that the colour-blind tell apart, the first one widest, so that where they
// agree all are seen; a disc where each begins, and in the legend how many of its poses lie so far
// out that the picture does not show them; below, a scale bar and a legend. Where a pixel holds
// several cells, thin walls stay visible.
RgbImage picture_of(const OccupancyMap& map, const std::vector<DrawnPath>& paths,
                    const PictureOptions& options = {});

}  // namespace mapbed
