#pragma once

#include <functional>

#include "core/log/sensor_log.h"

namespace mapbed {

// How the robot moved from one odometry reading to the next, as a log tells it.
struct OdometryStep {
  double from = 0.0;  // [s] stamp of the reading before
  double to = 0.0;    // [s]
  Pose2 motion;       // in the robot's frame at `from`
};

// The log with odometry that tells other steps; its first reading stays, and all others up to the
// first step that is told otherwise, byte for byte.
SensorLog with_steps(SensorLog log, const std::function<Pose2(const OdometryStep&)>& told);

}  // namespace mapbed
