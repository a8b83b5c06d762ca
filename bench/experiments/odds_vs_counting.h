#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// What one cell is thought to be after some beams ended in it and others went through, Figures 2.6
// and 2.7.
Experiment odds_vs_counting_experiment();

}  // namespace mapbed
