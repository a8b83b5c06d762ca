#pragma once

#include <variant>

#include "core/sensor/laser_scan.h"
#include "core/sensor/odometry.h"
#include "core/sensor/rfid_detections.h"

namespace mapbed {

// What a robot can tell. A new kind of sensor is a new header beside this one and a name in this
// list.
using Measurement = std::variant<Odometry, LaserScan, RfidDetections>;

inline double time_of(const Measurement& measurement) {
  return std::visit([](const auto& m) { return m.time; }, measurement);
}

}  // namespace mapbed
