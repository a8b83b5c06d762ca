#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/log/bearings.h"

// The lasers of a recorded log: where each of them looks, and who says so.

namespace mapbed {

struct LogOptions;
struct RecordedLog;

struct RecordedLaser {
  int laser = 0;
  std::size_t beams = 0;   // of most of its scans
  Bearings bearings;       // of these
  Pose2 robot_from_laser;  // of the first one
  std::string source;      // of the bearings: "its lines", "the number of beams, 360", …
  // What the log leaves possible beside `bearings`: nobody states them, or statements contradict
  // each other.
  std::vector<Bearings> candidates = {};
};

std::string name_of_laser(int laser);  // "front laser", "rear laser", "laser 3"

// "front laser: 360 beams, 0.5 deg from -90 deg (the number of beams, 360), at (0.1 m, 0 m, 0 deg)"
std::string to_string(const RecordedLaser& laser);

// Gives this laser's scans other bearings; those of scans with nearly as many beams follow.
void set_bearings(RecordedLog& log, RecordedLaser& laser, const Bearings& bearings,
                  const std::string& source);

// What became of the scans whose lines left something open.
struct CompletedLasers {
  std::map<std::size_t, long> unknown;                     // scans left out, by number of beams
  std::map<std::string, std::string> notes_of_parameters;  // by the name of the parameter
};

// Gives the scans of a log the bearings (where their step is 0) and mounts (where they are
// not a number) that their lines left open, takes those out whose bearings nobody knows, and lists
// the lasers. `in_lines` has, by laser, what else its lines could mean.
CompletedLasers complete_lasers(RecordedLog& log, const LogOptions& options,
                                const std::map<int, Bearings>& in_lines);

}  // namespace mapbed
