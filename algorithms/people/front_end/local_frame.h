#pragma once

#include <optional>
#include <span>

#include "algorithms/motion/odometry_track.h"
#include "algorithms/scan_matching/incremental_matcher.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"
#include "core/sensor/odometry.h"

namespace mapbed {

// A frame that follows the robot by scan matching, for what looks at the last seconds alone: it
// drifts, and never jumps for a loop's sake.
class LocalFrame {
 public:
  void add(const Odometry& reading);

  // local_from_robot of the scan that comes next: by odometry, or as the robot moved before.
  Pose2 predicted(double time) const;

  // local_from_robot of the scan. `beam_weights` are for the alignment, (3.11); empty: all count
  // fully.
  Pose2 add(const LaserScan& scan, std::span<const float> beam_weights);

 private:
  IncrementalMatcher matcher_;
  OdometryTrack odometry_;
  std::optional<Pose2> odometry_at_last_scan_;
  std::optional<double> last_time_;  // [s] of a scan
  Pose2 last_motion_;                // from the scan before last to the last
  double last_seconds_ = 0.0;        // [s] which that took
};

}  // namespace mapbed
