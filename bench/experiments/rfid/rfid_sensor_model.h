#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Figures 7.3 and 7.4: the robot turns before a tag at several distances; what its antennas hear
// is counted and fitted, and tried on a drive held out.
Experiment rfid_sensor_model_experiment();

}  // namespace mapbed
