#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// A graph of poses some of whose loop closures are false is optimised: who comes to the optimum
// that there would be without these?
Experiment false_loops_experiment();

}  // namespace mapbed
