#pragma once

#include <string>

#include "core/log/sensor_log.h"

namespace mapbed {

// The lasers of a log for other programs, of the first scan of each, as JSON:
//
//   {"units": "m, rad, s",
//    "lasers": [{"laser": 0, "x": 0.1, "y": 0.0, "theta": 0.0, "z": 0.3, "pitch": 0.0, "roll": 0.0,
//                "beams": 181, "first_bearing": -1.5708, "bearing_step": 0.017453,
//                "beam_period": 0.0, "max_range": 8.0}]}
//
// x, y, theta: robot_from_laser; ranges of max_range or more mean that nothing was hit.
std::string geometry_json(const SensorLog& log);

}  // namespace mapbed
