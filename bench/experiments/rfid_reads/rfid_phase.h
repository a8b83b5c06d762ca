#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Phases of tags' answers from places held out: does the way there and back say what they are?
Experiment rfid_phase_experiment();

}  // namespace mapbed
