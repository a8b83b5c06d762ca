#pragma once

#include <span>

#include "core/sensor/laser_scan.h"

namespace mapbed {

// The scan with those beams failed that weigh nothing: no method believes anything of them. One
// weight in [0, 1] for each beam.
LaserScan with_failed_beams(LaserScan scan, std::span<const float> beam_weights);

}  // namespace mapbed
