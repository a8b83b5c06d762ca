#pragma once

#include "bench/metrics/tracking_frame.h"

namespace mapbed {

struct OcclusionOptions {
  double longest = 3.0;       // [s] that nobody saw it; longer ones are not looked at
  double settling = 0.5;      // [s] before and after it, in which a match is looked for
  double max_distance = 0.5;  // [m] of a match
};

// A true object that is hidden in some frames after it counted, and counts again: was it the same
// track before and behind? An occlusion whose object no track had before it began is left out.
struct Occlusions {
  long all = 0;
  long kept = 0;                 // by the same track
  double fraction_kept() const;  // NaN: there were none
};

Occlusions occlusions_in(const TrackingFrames& frames, const OcclusionOptions& options = {});

}  // namespace mapbed
