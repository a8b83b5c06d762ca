#pragma once

#include <vector>

#include "bench/sources/run_input.h"

namespace mapbed {

// The scans of a log with their true poses, for experiments that are not about finding these.
struct PosedScans {
  std::vector<LaserScan> scans;
  Trajectory world_from_robot;  // of each scan
};

// The first `count` scans, or all where it is 0. Throws InputError where nobody knows the poses.
PosedScans posed_scans(const RunInput& input, int count = 0);

}  // namespace mapbed
