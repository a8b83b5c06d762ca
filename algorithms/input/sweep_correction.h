#pragma once

#include "core/geometry/trajectory.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// [s] after the scan's stamp, when its last beam was taken. The sweep begins with the stamp.
double sweep_duration(const LaserScan& scan);

// The scan with each beam from where the laser was when it was taken, by odometry (odometry_from_-
// robot, by time). As it is where the robot did not move noticeably meanwhile, where odometry does
// not reach from its first beam to its last, or where beams have their own places already.
LaserScan with_corrected_sweep(LaserScan scan, const Trajectory& odometry);

}  // namespace mapbed
