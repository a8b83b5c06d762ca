#include "algorithms/motion/track.h"

#include <algorithm>

#include "core/check.h"

namespace mapbed {

const Track::Break* Track::break_before(std::size_t anchor) const {
  const auto found = std::find_if(breaks.begin(), breaks.end(),
                                  [&](const Break& b) { return b.anchor == anchor; });
  return found == breaks.end() ? nullptr : &*found;
}

Pose2 motion_to(const Track& track, std::size_t anchor, const std::vector<Pose2>& anchors) {
  CHECK(anchor > 0 && anchor < anchors.size());
  return track.break_before(anchor) != nullptr
             ? motion_between(anchors[anchor - 1], anchors[anchor])
             : motion_between(track.track_from_anchors[anchor - 1],
                              track.track_from_anchors[anchor]);
}

PosePrior carried(const Track& track, const Track::Scan& scan, const std::vector<Pose2>& anchors) {
  CHECK(scan.anchors > 0);
  const std::size_t before = scan.anchors - 1;
  const auto carried_from = [&](std::size_t anchor) {
    return gaussian_after(anchors[anchor],
                          motion_between(track.track_from_anchors[anchor], scan.track_from_robot),
                          track.errors);
  };
  if (before + 1 >= anchors.size()) return carried_from(before);
  if (const Track::Break* broken = track.break_before(before + 1)) {
    return carried_from(scan.time < broken->time ? before : before + 1);
  }
  return fused(carried_from(before), carried_from(before + 1));
}

Trajectory carried_trajectory(const Track& track, const std::vector<Pose2>& anchors) {
  Trajectory trajectory;
  trajectory.reserve(track.scans.size());
  for (const Track::Scan& scan : track.scans) {
    trajectory.push_back({scan.time, scan.is_anchor ? anchors[scan.anchors - 1]
                                                    : carried(track, scan, anchors).mean});
  }
  return trajectory;
}

}  // namespace mapbed
