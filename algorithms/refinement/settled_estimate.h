#pragma once

#include <vector>

#include <Eigen/Core>

#include "algorithms/rbpf/scan_condenser.h"
#include "algorithms/refinement/settling.h"
#include "core/geometry/trajectory.h"

namespace mapbed {

// End points of a scan that is kept to be matched beside the path [m], in the robot frame.
using KeptHits = std::vector<Eigen::Vector2f>;

// Where the robot was carried, or may have been: no motion leads from the update before to
// `update`.
struct Break {
  double time = 0.0;       // [s] scans since then belong to the update after it
  std::size_t update = 0;  // the first one after it
};

// A path through the updates, `poses`, without what drawing added.
SettledPath settled_path(const std::vector<Pose2>& poses,
                         const std::vector<ScanCondenser::Update>& updates,
                         const std::vector<ScanForWeighting>& scans,
                         const std::vector<Break>& breaks, const MotionModelOptions& motion_errors,
                         const SettlingOptions& options);

// Where all scans are: those between updates are matched with the map of the path, from where the
// updates about them have them. `hits` has an entry for each scan; those of updates are not read.
Trajectory with_scans_between(const SettledPath& path,
                              const std::vector<ScanCondenser::Update>& updates,
                              const std::vector<ScanCondenser::Scan>& scans,
                              const std::vector<KeptHits>& hits, const std::vector<Break>& breaks,
                              const MotionModelOptions& motion_errors,
                              const SettlingOptions& options);

}  // namespace mapbed
