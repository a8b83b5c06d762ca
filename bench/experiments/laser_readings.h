#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Readings of the simulated laser, through scene, spot and noise, against the distribution that
// its description promises.
Experiment laser_readings_experiment();

}  // namespace mapbed
