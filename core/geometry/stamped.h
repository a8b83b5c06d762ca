#pragma once

namespace mapbed {

// A pose, in the plane or in space, and when it was held.
template <class Pose>
struct Stamped {
  double time = 0.0;  // [s] absolute, as in the log
  Pose pose;          // world_from_robot
};

}  // namespace mapbed
