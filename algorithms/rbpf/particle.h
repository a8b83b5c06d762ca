#pragma once

#include <memory>

#include "algorithms/field/surface_map.h"
#include "algorithms/particles/history.h"

namespace mapbed {

struct Particle {
  Pose2 pose;  // map_from_robot at the last update
  double log_weight = 0.0;
  // Of the scans in its history but the newest one, which enters with the next update: the map is
  // read then anyway, and how much memory is read bounds the speed.
  SurfaceMap map;
  std::shared_ptr<HistoryNode> history;
};

}  // namespace mapbed
