#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/log/bearings.h"
#include "core/log/log_file.h"

// What a scan needs beside its ranges, where its line does not have it.

namespace mapbed {

inline constexpr double kAbsurdRange = 1000.0;  // [m] no laser of a robot reaches farther
// A reading of which the log's format says that it is none: no number, or nearer than the laser can
// see. Other than 0, which LogOptions::zero is about; LogBuilder::add() makes it 0.
inline constexpr double kNoReading = -std::numeric_limits<double>::infinity();

// What CARMEN's parameters of a laser begin with, or are called. Two have names, front (0) and rear
// (1); further ones are laser3, laser4, … as in ROBOTLASER3.
struct LaserParameterNames {
  std::string mount;      // "robot_frontlaser_", before offset, side_offset and angular_offset
  std::string bearings;   // "laser_front_laser_", before resolution, fov, first_bearing, max_range
  std::string max_range;  // "robot_front_laser_max"
};
LaserParameterNames parameter_names_of(int laser);

// What the parameters say of where its beams point.
StatedBearings stated_bearings(const RecordedLog& log, int laser);

// Where a laser stands on the robot. The options win, then PARAM robot_frontlaser_offset or
// robot_rearlaser_offset (with _side_offset and _angular_offset); otherwise the robot's centre. A
// rear laser (1) looks backwards.
Pose2 mount_of(int laser, const RecordedLog& log, const LogOptions& options);

// From which reading on nothing was hit. The option wins, then what a log states that says by
// infinite readings where nothing was hit; else the smaller of what the log states
// (the line, or PARAM robot_front_laser_max or laser_front_laser_max_range) and what the readings
// show:
//   - a reading of 81.83 to 81.91 m, 8.183 to 8.191 m or 32.759 to 32.767 m is one of the nine
//   error
//     codes of the SICK scanners in cm or mm, which end their scale: 81.83, 8.183, 32.759;
//   - otherwise a value that is the largest one, within 1 %, and comes up ten times as often as
//     any other in the upper half of the scale, and at least ten times.
// Where neither is there, all readings count as hits and the next of 8, 16, 30, 50, 81.83 m above
// them is the maximum range.
double max_range_of(const std::vector<const LaserScan*>& scans, double stated);

// The same for all scans of a log, laser by laser; infinite readings become the maximum range.
void complete_max_range(RecordedLog& log, const LogOptions& options);

}  // namespace mapbed
