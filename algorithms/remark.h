#pragma once

#include <optional>
#include <string>

#include "core/time_interval.h"

namespace mapbed {

// What a remark is about, so that it can be told apart without reading its words. Each kind of
// trouble has one, whether or not a method notices it already.
enum class RemarkKind : int {
  note,              // nothing is wrong
  tilted_laser,      // left out
  no_odometry,       // for a while, or at all
  odometry_stall,    // it stood still and caught up
  odometry_lag,      // its stamps are late
  odometry_jump,     // between two readings
  odometry_restart,  // its counters began again
  odometry_scale,    // all its steps are too long or too short
  odometry_drift,    // it turns while the robot drives straight
  odometry_slip,     // the robot moved, and it did not tell
  no_scan,           // for a while
  repeated_scan,     // scans that are no news
  stamp_order,       // of scans
  blind_laser,       // it sees nothing
  few_beams,         // that say anything
  blocked_beams,     // that see dirt or the robot itself, or are stuck
  no_return,         // beams without return read as if something were there
  beam_geometry,     // beams do not point where the log says
  laser_mount,       // the laser does not look where the log says
  skewed_sweep,      // beams of one scan taken at different places
  unknown_motion,    // neither odometry nor scans say how the robot moved
  lost,              // the robot may be anywhere
  relocalized,       // it was lost, and found again
};

struct Remark {
  RemarkKind kind = RemarkKind::note;
  std::string text;                       // in one line: what, when, what was done about it
  std::optional<TimeInterval> when = {};  // stamps of the log; none: all along
};

}  // namespace mapbed
