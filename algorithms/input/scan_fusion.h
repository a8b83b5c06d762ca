#pragma once

#include <vector>

#include "core/config/option.h"
#include "core/geometry/trajectory.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

struct ScanFusionOptions {
  double within = 0.005;  // [s]
};

template <class Visitor>
void visit_fields(ScanFusionOptions& o, Visitor&& visit) {
  visit("within", o.within, Unit::second, between(0.0, 0.1),
        "scans of several lasers whose stamps differ by at most this are one measurement; 0: of "
        "the same stamp alone");
}

// Whether two scans are of different lasers that look along the floor, at one instant.
bool are_of_one_instant(const LaserScan& a, const LaserScan& b, const ScanFusionOptions& options);

// Scans of one instant as one, with the stamp of the first. How the robot moved since then is told
// by odometry (odometry_from_robot, by time) where it reaches so far. Of lasers of a shorter range
// than the others, beams without return count as failed: where they end is not told by max_range.
LaserScan fused(std::vector<LaserScan> scans, const Trajectory& odometry = {});

}  // namespace mapbed
