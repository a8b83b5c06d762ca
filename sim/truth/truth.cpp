#include "sim/truth/truth.h"

#include <algorithm>

namespace mapbed {

bool TruthEntity::is_dynamic() const {
  return kind == EntityKind::person || kind == EntityKind::door || kind == EntityKind::vehicle ||
         kind == EntityKind::robot || kind == EntityKind::movable;
}

Trajectory trajectory_of(const Truth& truth) {
  Trajectory trajectory;
  trajectory.reserve(truth.states.size());
  for (const StampedStates& s : truth.states) trajectory.push_back({s.time, s.world_from_robot});
  return trajectory;
}

const BeamTruthOfScan* beams_of(const Truth& truth, double time, int laser) {
  auto scan = std::lower_bound(truth.beams.begin(), truth.beams.end(), time,
                               [](const BeamTruthOfScan& s, double t) { return s.time < t; });
  for (; scan != truth.beams.end() && scan->time == time; ++scan) {
    if (scan->laser == laser) return &*scan;
  }
  return nullptr;
}

}  // namespace mapbed
