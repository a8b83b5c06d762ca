#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algorithms/remark.h"
#include "core/geometry/trajectory.h"
#include "core/labels/beam_labels.h"
#include "core/labels/tracks.h"
#include "core/sensor/laser_scan.h"
#include "core/sensor/odometry.h"

namespace mapbed {

// What a filter says in the end of all that it was given.
struct FilterResult {
  BeamLabels labels;             // one for each scan
  std::optional<Tracks> tracks;  // in the frame of the map
  std::vector<Remark> remarks;
};

// Tells which beams met something that does not belong to the place, in front of any method. A
// filter looks for the robot's motion on its own, since the path of a method may jump where a loop
// is closed.
class BeamFilter {
 public:
  virtual ~BeamFilter() = default;

  virtual void add(const Odometry& reading) = 0;

  // Scans of level lasers, in order of time, each with what is known of its beams already (may be
  // empty). How much of each beam a method may believe when it looks for the robot, in [0, 1];
  // empty where nothing can be told before all scans are in.
  virtual std::vector<float> add(const LaserScan& scan, std::span<const float> beam_weights) = 0;

  // With the path that the method found, one pose for each scan.
  virtual FilterResult result(const Trajectory& map_from_robot) const = 0;
};

}  // namespace mapbed
