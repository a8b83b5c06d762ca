#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// A method finds the trajectory in a log, which is evaluated against the true one.
Experiment slam_experiment();

}  // namespace mapbed
