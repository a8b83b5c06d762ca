#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Chapter 3's filter follows people through drives whose truth is known: what its scans said of
// people and of everything else is counted, and becomes a parameter file of
// algorithms/people/people_models.
Experiment learned_people_experiment();

}  // namespace mapbed
