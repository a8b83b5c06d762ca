#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// A method finds the trajectory in a log, and is judged by the true one.
Experiment slam_experiment();

}  // namespace mapbed
