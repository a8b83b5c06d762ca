#pragma once

#include <string>

#include "worlds/world.h"

namespace mapbed {

// Walls from the plan of a building: an image with its map_server file (core/image/map_server.h),
// as written by most mapping programs. Every pixel that is occupied with more than occupied_thresh
// becomes solid up to `height`; runs of pixels are merged into boxes. Unknown ones stay open.
struct PlanOptions {
  std::string file;     // of map_server, beside its image
  double height = 2.5;  // [m]
  std::string material = "plaster";
};

// Adds the walls, as one entity `plan`, and a floor under all of the image. Throws InputError where
// a file is missing, damaged or has no occupied pixel.
void add_plan(World& world, const PlanOptions& options);

}  // namespace mapbed
