#pragma once

#include <memory>
#include <vector>

#include "algorithms/estimator.h"
#include "algorithms/grid/map_builder.h"
#include "algorithms/grid/occupancy_map.h"
#include "core/log/sensor_log.h"
#include "core/time_interval.h"

namespace mapbed {

// One drive cut into blocks of equal time: from every other one, the first among them, a map is
// made, and in the others a robot is to be found in it that the map knows nothing of.
struct DriveBlocks {
  std::shared_ptr<const OccupancyMap> map;  // as map servers are given it
  std::vector<Pose2> mapped_from;           // map_from_robot of its scans
  struct Block {
    SensorLog log;
    Trajectory truth;          // map_from_robot at its scans
    bool is_near_map = false;  // all of them lie near one of mapped_from
  };
  std::vector<Block> blocks;
};

// Of a log whose path is known at the scans of level lasers; `near` [m].
DriveBlocks blocks_of(const SensorLog& log, const Trajectory& map_from_robot, double seconds,
                      double near, const MapOptions& options);

// How a robot was found in a block. NaN where there is nothing to be told.
struct BlockResult {
  bool is_found = false;       // in the end it is where it is taken to be, and that is known
  double seconds_to_it = 0.0;  // from the first scan to that from which on it is
  int scans = 0;
  int unknown = 0;                  // scans whose place is said not to be known
  int wrongly_known = 0;            // scans whose place is known, and wrong
  int off = 0;                      // scans with a wrong pose, known or not
  std::vector<double> errors = {};  // [m] where the place is known
};

// A pose is wrong that is farther than `limit` [m] from the true one.
BlockResult judged(const Estimate& estimate, const Trajectory& truth, double limit);

}  // namespace mapbed
