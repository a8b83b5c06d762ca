#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Robots are localised in a map of their own drive: of every other half minute, at the poses that a
// method found in the whole of it, or at the true ones.
Experiment localization_experiment();

}  // namespace mapbed
