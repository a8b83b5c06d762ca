#pragma once

#include <memory>
#include <string>

#include "algorithms/estimator.h"
#include "algorithms/grid/occupancy_map.h"
#include "bench/cli/map_config.h"
#include "core/log/log_file.h"

namespace mapbed {

// A robot's path in a map that was given.
struct LocalizeRun {
  MapConfig config;  // its `map` and `map_file` mean nothing here
  std::string map_path;
  std::shared_ptr<const OccupancyMap> map;
  std::string tags_path = {};  // empty: none are given
  Estimate estimate;
  bool complete = true;
};

// In scans and in time.
struct KnownSummary {
  int scans = 0;
  int known_scans = 0;
  int times_lost = 0;         // after it was known
  double known_from = -1.0;   // [s] since the first scan; below 0: never
  double lost_seconds = 0.0;  // [s] of the log, in which the place was not known
};
KnownSummary known_summary(const Estimate& estimate);

// The folder's files, all of them or none:
//
//   trajectory.tum   a pose in the map's frame for each scan, by the log's own stamps
//   known.csv        for each scan whether its pose is known, and its sigmas
//   picture.png      the map with the path, known and not known apart
//   config.yaml      complete; `mapbed localize LOG --map MAP --config` of it repeats the run
//   summary.json     the rest in numbers; written last
//
// Throws InputError where one cannot be written. The folder is locked.
void write_localize_run(const std::string& folder, const std::string& log_name,
                        const LocalizeRun& run);

// Throws InputError where one of these would take the place of somebody else's file.
void refuse_foreign_localize_files(const std::string& folder);

// The log whose path a folder holds; empty where it holds none.
std::string log_of_localization(const std::string& folder);

}  // namespace mapbed
