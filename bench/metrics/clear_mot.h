#pragma once

#include "bench/metrics/tracking_frame.h"

namespace mapbed {

// The CLEAR MOT metrics (Bernardin and Stiefelhagen, "Evaluating multiple object tracking
// performance", 2008). A pair that was matched stays so as long as both are within the distance;
// all others are matched anew in each frame.
struct ClearMot {
  long truths = 0;           // true objects over all frames
  long matches = 0;          // of these
  long false_positives = 0;  // tracks without a true object
  long switches = 0;         // true objects that were matched to another track than the last time
  double sum_of_distances = 0.0;  // [m] of all matches

  long misses() const { return truths - matches; }
  double accuracy() const;   // MOTA: 1 - (misses + false positives + switches) / truths; NaN: none
  double precision() const;  // MOTP [m]: mean distance of matches; NaN: there are none
};

ClearMot clear_mot(const TrackingFrames& frames, double max_distance);

}  // namespace mapbed
