#pragma once

#include <vector>

#include "core/sensor/measurement.h"

namespace mapbed {

// Everything that a robot measured, in order of time. Odometry of the same stamp as a scan comes
// first.
using SensorLog = std::vector<Measurement>;

}  // namespace mapbed
