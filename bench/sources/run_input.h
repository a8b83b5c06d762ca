#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "bench/faults/faults.h"
#include "bench/metrics/relations.h"
#include "core/geometry/trajectory.h"
#include "core/interrupted.h"
#include "core/log/sensor_log.h"
#include "core/random.h"
#include "worlds/geometry/raster.h"

namespace mapbed {

class RunViewer;
class SharedWork;
struct Recording;
struct World;

// What a log offers. Only metrics may look beyond the measurements.
struct LogInput {
  SensorLog log;                         // empty where the experiment needs none
  SensorLog clean;                       // the same before faults were put in, if there are any
  std::vector<FaultInLog> faults;        // that were planned
  Trajectory truth;                      // world_from_robot, by time; empty: nobody knows
  const Recording* recording = nullptr;  // null for a recorded log
  const World* world = nullptr;          // the same
  // The world's true map with cells of this size [m]; none for a recorded log.
  std::function<const TrueMap&(double resolution)> true_map = {};
  // How the robot truly moved between pairs of stamps; none where nobody measured that.
  std::function<const MeasuredRelations&()> relations = {};
  // The same between poses of another program's path that are near each other, see pairs.h.
  std::function<const std::vector<Relation>&()> pairs = {};
  // What runs on the same clean log, noise included, work out once for all of them; null where
  // there is no log.
  SharedWork* shared = nullptr;
};

// What a run works on: the scenario's own log and all else that the run is given.
struct RunInput : LogInput {
  std::map<std::string, LogInput> further = {};  // Experiment::further_logs, by their names
  Rng rng{0};
  std::uint64_t seed = 0;             // that `rng` comes from
  GoesOn goes_on = {};                // for work that can be ended half-way
  std::set<std::string> wanted = {};  // metrics and series; others need not be worked out
  bool shown = false;                 // pictures of this run are wanted too
  bool alone = false;                 // done again by itself: for map servers, too
  RunViewer* viewer = nullptr;        // looks at its method at work; null: nobody does
  // Which run it is, for them: "raw, people = 5"; empty: seeds alone set the runs apart.
  std::string label = {};
};

// Without what comes later than `longest` [s] after the log's start; 0: all of it.
RunInput shortened(RunInput input, double longest);

}  // namespace mapbed
