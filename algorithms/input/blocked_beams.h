#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "algorithms/remark.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// Beams of one laser that read the same whatever way the robot looks: something that rides along is
// before them (dirt on the window, a part of the robot), or they are stuck.
struct BlockedBeams {
  std::vector<bool> is_blocked;  // by beam, of scans with so many beams
  double nearest = 0.0;          // [m] that they read
  double farthest = 0.0;         // [m]
  std::size_t count() const;
};

// By laser; those without blocked beams are left out. Told by odometry: the robot must have looked
// round, into most directions, so that no wall can be as far in all of them. Where more than half
// of the beams read the same, it is the world, or odometry turns and the robot does not.
std::map<int, BlockedBeams> blocked_beams(const SensorLog& log);

// The scan with these as beams that failed.
LaserScan without_blocked(LaserScan scan, const std::map<int, BlockedBeams>& blocked);

std::vector<Remark> remarks_on(const std::map<int, BlockedBeams>& blocked);

}  // namespace mapbed
