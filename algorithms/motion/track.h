#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/motion/motion_model.h"
#include "core/geometry/trajectory.h"

namespace mapbed {

// How scans lie to each other by odometry and scan matching alone, along a path that is known at
// some of them: the anchors, as a filter's updates.
struct Track {
  struct Scan {
    double time = 0.0;  // [s]
    Pose2 track_from_robot;
    std::size_t anchors = 0;  // up to this scan, itself included; the first scan is an anchor
    bool is_anchor = false;
  };
  // The robot was carried, or may have been: no motion leads from the anchor before to `anchor`.
  struct Break {
    double time = 0.0;       // [s] scans since then belong to the anchor after it
    std::size_t anchor = 0;  // the first one after it
  };
  std::vector<Scan> scans;
  std::vector<Pose2> track_from_anchors;
  std::vector<Break> breaks;
  MotionModelOptions errors;  // of motions along it

  const Break* break_before(std::size_t anchor) const;  // null where there is none
};

// The motion to an anchor from the one before, which the path's own `anchors` tell across a break.
Pose2 motion_to(const Track& track, std::size_t anchor, const std::vector<Pose2>& anchors);

// Where a scan between two anchors is, carried from both along the track.
PosePrior carried(const Track& track, const Track::Scan& scan, const std::vector<Pose2>& anchors);

// The poses of all scans.
Trajectory carried_trajectory(const Track& track, const std::vector<Pose2>& anchors);

}  // namespace mapbed
