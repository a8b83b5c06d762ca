#pragma once

#include <vector>

#include "core/geometry/trajectory.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// An inventory round with the pose from which it was made.
struct PosedRound {
  const RfidDetections* round = nullptr;  // in the log
  Pose2 map_from_robot;

  Pose2 map_from_antenna() const { return map_from_robot * round->robot_from_antenna.planar; }
};

// All rounds of a log, which must outlive them, but for those outside of the path's time.
std::vector<PosedRound> posed_rounds(const SensorLog& log, const Trajectory& map_from_robot);

// The antennas that speak in the log: one more than the largest number. Throws InputError where
// none does.
int antennas_in(const SensorLog& log);

}  // namespace mapbed
