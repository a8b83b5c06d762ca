#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// A map of the scans at their true poses: what the sensor model alone makes of them, Figures 2.8
// and 2.9.
Experiment known_poses_experiment();

}  // namespace mapbed
