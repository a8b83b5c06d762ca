#pragma once

#include "bench/metrics/tracking_frame.h"

namespace mapbed {

// IDF1 (Ristani et al., "Performance measures and a data set for multi-target, multi-camera
// tracking", 2016): each true object is given one track for the whole recording, so that they agree
// in as many frames as possible. 2 IDTP / (2 IDTP + IDFP + IDFN); NaN where nobody is there at all.
double identity_f1(const TrackingFrames& frames, double max_distance);

}  // namespace mapbed
