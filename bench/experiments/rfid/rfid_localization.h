#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Sections 7.5.2 and 7.5.3: one drive maps the place and its tags, in another one the robot, or a
// person, is found there by laser, RFID or both.
Experiment rfid_localization_experiment();

}  // namespace mapbed
