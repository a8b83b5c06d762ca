#pragma once

#include <string>
#include <vector>

#include "algorithms/rfid/antenna_model.h"
#include "core/file/input_file.h"

namespace mapbed {

// What was learned of a robot's antennas, by their numbers: a parameter file in rfid_models/.
using RfidModel = std::vector<AntennaModel>;

// "piecewise", "histogram" or "smooth".
std::string kind_of(const AntennaModel& antenna);

// A parameter file, by its name in algorithms/rfid/rfid_models or by its path. Throws InputError.
RfidModel load_rfid_model(const std::string& name_or_path);
InputFile rfid_model_file(const std::string& name_or_path);  // throws InputError

// As such a file has it, behind a comment of whole lines.
std::string to_yaml(const RfidModel& model, const std::string& comment = {});

}  // namespace mapbed
