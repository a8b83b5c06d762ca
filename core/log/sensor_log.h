#pragma once

#include <vector>

#include "core/geometry/trajectory.h"
#include "core/sensor/measurement.h"

namespace mapbed {

// Everything that a robot measured, in order of time. Odometry of the same stamp as a scan comes
// first.
using SensorLog = std::vector<Measurement>;

bool has_scans(const SensorLog& log);
Trajectory odometry_of(const SensorLog& log);  // odometry_from_robot at each of its readings

}  // namespace mapbed
