#pragma once

#include <string>
#include <vector>

#include "algorithms/rfid/antenna_model.h"
#include "core/file/input_file.h"

namespace mapbed {

// What was learned of a robot's antennas, by their numbers: a parameter file in rfid_models/.
using LearnedRfid = std::vector<AntennaModel>;

// "piecewise", "histogram" or "smooth".
std::string kind_of(const AntennaModel& antenna);

// A parameter file, by its name in algorithms/rfid/rfid_models or by its path. Throws InputError.
LearnedRfid load_learned_rfid(const std::string& name_or_path);
InputFile learned_rfid_file(const std::string& name_or_path);  // throws InputError

// As such a file has it, behind a comment of whole lines.
std::string to_yaml(const LearnedRfid& model, const std::string& comment = {});

}  // namespace mapbed
