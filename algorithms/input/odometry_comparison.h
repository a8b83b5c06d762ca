#pragma once

#include <vector>

#include "algorithms/remark.h"
#include "core/geometry/trajectory.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// What an estimate shows of the odometry that it was made with, over the whole log: where the two
// differ by more than both claim, and which one was believed. `estimate` has a pose for each scan;
// one that follows odometry alone shows nothing.
//
//   - odometry that stands still while the robot moves, and tells the way later or not at all;
//   - wheels that slip: seconds in which odometry is off by more than slipping wheels mostly are;
//   - steps that are all too long or too short, or turn while the robot drives straight;
//   - stamps that are late;
//   - and a robot that drives askew, as the laser does not look where the log says.
std::vector<Remark> remarks_on_odometry(const SensorLog& log, const Trajectory& estimate);

}  // namespace mapbed
