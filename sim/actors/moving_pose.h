#pragma once

#include <cstdint>

#include "core/geometry/pose3.h"

namespace mapbed {

// Whether a thing moves: one that is still does not for the whole recording (a wall, a parked car),
// one that waits may at any moment (somebody who stands, a door that is open).
enum class Motion : std::uint8_t { still, waiting, moving };

// Where one part of something that can move is, at one moment.
struct MovingPose {
  int entity = 0;
  int part = 0;  // index into the entity's parts
  Pose3 world_from_part;
  Motion motion = Motion::waiting;
};

}  // namespace mapbed
