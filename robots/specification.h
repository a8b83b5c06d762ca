#pragma once

#include <string>

#include "robots/robot.h"
#include "robots/sensor_model.h"

namespace mapbed {

// What a sensor promises, in one line: range, field of view, step, rate, noise.
std::string specification(const SensorModel& sensor);

// The same of a robot: size, mass, drive with its limits, sensors.
std::string specification(const Robot& robot);

}  // namespace mapbed
