#pragma once

#include <optional>
#include <vector>

#include "algorithms/remark.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// By how much the stamps of odometry are late [s], negative where they are early: two computers
// whose clocks differ, or a reading that waits for its message. It shows where the robot turns:
// there scans that follow each other are turned too, and by how much is read off their ranges
// alone, whatever the place looks like. None where the log does not tell it clearly: too few turns,
// or turns that are explained as well without.
std::optional<double> odometry_lag(const SensorLog& log);

// The log with its odometry where it belongs, in order of time.
SensorLog without_lag(SensorLog log, double lag);

Remark remark_on_lag(double lag);

}  // namespace mapbed
