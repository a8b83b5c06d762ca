#pragma once

#include "bench/metrics/tracking_frame.h"

namespace mapbed {

// HOTA (Luiten et al., "HOTA: a higher order metric for evaluating multi-object tracking", 2021),
// the mean over the thresholds 0.05, 0.10, ... 0.95 of similarity; that of two positions is
// 1 - distance / zero_distance, at least 0, as in TrackEval. NaN where nobody is there at all.
struct Hota {
  double hota = 0.0;         // mean of sqrt(detection * association)
  double detection = 0.0;    // DetA, mean
  double association = 0.0;  // AssA, mean
};

Hota hota(const TrackingFrames& frames, double zero_distance);

}  // namespace mapbed
