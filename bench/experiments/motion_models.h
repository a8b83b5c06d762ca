#pragma once

#include "bench/experiments/experiment.h"

namespace mapbed {

// Errors of raw odometry and of scan matching, learned from one half of a drive and checked on the
// other; and where the robot may be after ten moves under either model, Figures 5.2 and 5.3.
Experiment motion_models_experiment();

}  // namespace mapbed
