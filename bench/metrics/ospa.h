#pragma once

#include "bench/metrics/tracking_frame.h"

namespace mapbed {

// OSPA (Schuhmacher, Vo and Vo, "A consistent metric for performance evaluation of multi-object
// filters", 2008) of order 1: the mean distance [m] of the best pairs, each at most `cut_off` [m],
// with `cut_off` for everybody who is left over; 0 where nobody is there and nobody is held to be.
double ospa(const TrackingFrame& frame, double cut_off);

// Its mean over all frames; NaN where there are none.
double mean_ospa(const TrackingFrames& frames, double cut_off);

}  // namespace mapbed
