#pragma once

#include "core/geometry/pose3.h"
#include "worlds/geometry/shape.h"

namespace mapbed {

// A part at its place, and what a hit on it is called.
struct PlacedPart {
  Geometry geometry = {};
  Pose3 world_from_part = {};
  int entity = 0;
  int part = 0;
  int material = 0;
  bool glass = false;  // lets rays with `through_glass` pass
  bool visible = true;
};

}  // namespace mapbed
