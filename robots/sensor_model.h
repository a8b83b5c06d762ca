#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/input_error.h"
#include "robots/laser_model.h"
#include "robots/rfid_model.h"

namespace mapbed {

// What a sensor is. A new kind is a header beside laser_model.h, a name in this list and a line in
// the table of sensor_model.cpp.
using SensorModel = std::variant<LaserModel, RfidModel>;

// The file of a name (robots/sensors/NAME.yaml) or of a path. Throws InputError.
std::string sensor_file(const std::string& name_or_path);

// By name or by the path of a sensor file, whose `kind` says what it is;
// without one it is a laser. Throws InputError with place, reason and remedy.
SensorModel load_sensor(const std::string& name_or_path);
LaserModel load_laser(const std::string& name_or_path);

std::vector<std::string> sensor_names();

// Throws InputError where the values do not go together, with `place` in the message.
void check_sensor(const SensorModel& model, const SourceLocation& place);

}  // namespace mapbed
