#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Maps of end points alone, by the odds and by the counting model, of the same scans at their true
// poses: Figure 2.10.
Experiment end_points_experiment();

}  // namespace mapbed
