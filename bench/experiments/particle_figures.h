#pragma once

#include <string>
#include <vector>

#include "algorithms/estimator.h"
#include "bench/results/result_file.h"

namespace mapbed {

// The paths that a method holds possible at some time of the log, Figure 5.7; in the frame of
// world_from_map. Empty for methods that hold one only. `label` tells which run it is.
std::vector<ResultFile> path_figure(const Hypotheses& hypotheses, const Trajectory& truth,
                                    const Pose2& world_from_map, double seconds,
                                    const std::string& label);

}  // namespace mapbed
