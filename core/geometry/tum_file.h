#pragma once

#include <string>
#include <string_view>

#include "core/geometry/trajectory.h"

// Trajectories as text, plain or gzipped, a pose a line:
//
//   t x y z qx qy qz qw     the TUM format; evo and others read it
//   t x y theta             [s], [m], [rad]
//
// '#' begins a comment. Of a pose in space the heading of its x axis is kept. Both kinds of lines
// are told by their number of fields.

namespace mapbed {

// In order of time, whatever the order in the file: reference poses of public logs jump back by
// parts of a second. Throw InputError, with the line, for other lines, a quaternion whose length is
// not 1 within 1 %, and a file without any pose.
Trajectory load_trajectory(const std::string& path);
Trajectory parse_trajectory(const std::string& name, std::string_view text);

// TUM lines: stamps to the microsecond, positions and quaternions to 9 decimals.
void write_trajectory(const std::string& path, const Trajectory& trajectory);
std::string tum_text(const Trajectory& trajectory);

}  // namespace mapbed
