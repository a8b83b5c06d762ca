#pragma once

#include <cstdint>
#include <vector>

#include "sim/actors/moving_pose.h"

namespace mapbed {

// What the axis of a beam truly meets.
struct BeamTruth {
  float range = 0.0F;             // [m] infinite: nothing
  std::int32_t entity = -1;       // -1: nothing
  std::int32_t part = -1;         // index into the entity's parts
  std::int32_t material = -1;     // index into the world's materials
  Motion motion = Motion::still;  // of the part, at this moment
};

// All beams of one scan.
struct BeamTruthOfScan {
  double time = 0.0;  // [s] the scan's own stamp
  int laser = 0;      // as LaserScan counts
  std::vector<BeamTruth> beams;
};

}  // namespace mapbed
