#pragma once

#include <vector>

#include "core/log/sensor_log.h"
#include "core/random.h"
#include "core/time_interval.h"

namespace mapbed {

// From the first measurement to the last; the log is not empty.
TimeInterval whole_of(const SensorLog& log);

// Stamps [s] at which a fault strikes that lasts `seconds`: `at`, counted from the log's start, in
// order; where that is empty, one by chance. By chance is a stamp of odometry, not in the first or
// last tenth of the log, after which the robot moves for so long at least as much as it does on
// average: by its odometry, a radian like half a metre. None for an empty log.
std::vector<double> fault_instants(const SensorLog& log, const std::vector<double>& at,
                                   double seconds, Rng& rng);

}  // namespace mapbed
