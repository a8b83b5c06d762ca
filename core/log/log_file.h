#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/trajectory.h"
#include "core/input_error.h"
#include "core/interrupted.h"
#include "core/log/log_options.h"
#include "core/log/recorded_lasers.h"
#include "core/log/sensor_log.h"

// Recorded logs from files, plain or gzipped; the dialect is told by the content:
//
//   CARMEN     FLASER, RLASER, ROBOTLASER1/2, ODOM, RFID, TRUEPOS, PARAM     see carmen_log.h
//   CoreSLAM   encoder ticks and 682 ranges in millimetres a line      see coreslam_log.h
//   DP-SLAM    `Odometry x y theta`, `Laser n r…`, no stamps           see dpslam_log.h
//   scan list  `t n r…`, the scan geometry in its '#' header           see scan_list_log.h
//   bags       of ROS 1 and ROS 2, the latter also as folders, MCAP    see bags/bag_log.h
//
// Every line is a message of its own, so a broken one is left out, counted and named in the
// warnings; so is a message of a bag. A log of which more than one in ten messages is broken is
// refused.

namespace mapbed {

// Something odd that was read past.
struct LogWarning {
  SourceLocation place;  // of the first one
  std::string reason;    // "truncated FLASER line: left out"
  long count = 1;
};

std::string to_string(const LogWarning& warning);  // one line: place, reason, count

// A topic of a bag.
struct RecordedTopic {
  std::string name;  // "/scan"
  std::string type;  // "sensor_msgs/LaserScan"
  long messages = 0;
  std::string unread = {};  // why nothing is made of its messages; empty: they can be of use
};

// What a bag holds, of whatever kind.
struct BagContents {
  std::string format;  // "ROS 1 bag", "ROS 2 bag", "MCAP"
  std::vector<RecordedTopic> topics;
  double seconds = 0.0;  // from the first to the last message, as they were recorded
};

struct RecordedLog {
  std::string format;                             // "CARMEN", "CoreSLAM", "scan list", "MCAP", …
  SensorLog measurements;                         // by time; not odometry alone
  Trajectory true_poses;                          // world_from_robot; where the log has them
  bool has_stamps = true;                         // false: the times are made up
  std::map<std::string, std::string> parameters;  // CARMEN's PARAM lines
  std::vector<RecordedLaser> lasers;              // by number
  std::vector<LogWarning> warnings;
};

// Throw InputError where nothing sensible can be read.
RecordedLog load_log(const std::string& path, const LogOptions& options = {},
                     const GoesOn& goes_on = {});
RecordedLog parse_log(const std::string& name, std::string_view text,
                      const LogOptions& options = {});

// The files that a log is read from, in their order: itself, or those of a bag's folder, with what
// it says of them. Throws InputError for a folder that is no bag.
std::vector<std::string> files_of_log(const std::string& path);

// None where the file or folder is no bag. Throws InputError where it cannot be read.
std::optional<BagContents> bag_contents(const std::string& path);

}  // namespace mapbed
