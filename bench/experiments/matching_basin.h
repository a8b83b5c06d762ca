#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// From how far away a matcher finds back: scans are matched with a local map at true poses,
// starting from wrong ones, Figures 2.12 and 2.13.
Experiment matching_basin_experiment();

}  // namespace mapbed
