#pragma once

#include <variant>

#include "sim/sensors/ideal_odometry.h"
#include "sim/sensors/ideal_rfid.h"
#include "sim/sensors/ideal_scan.h"

namespace mapbed {

// What a sensor would say without noise, with all that noise needs to know. A new kind of sensor is
// a header beside this one, a name in this list and a line in sim/noise/sensor_noise.cpp.
using IdealReading = std::variant<IdealOdometry, IdealScan, IdealRfid>;

inline double time_of(const IdealReading& reading) {
  return std::visit([](const auto& r) { return r.time; }, reading);
}

}  // namespace mapbed
