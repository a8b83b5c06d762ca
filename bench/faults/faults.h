#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithms/remark.h"
#include "bench/faults/broken_log.h"
#include "core/config/configured.h"
#include "core/config/settings.h"
#include "core/geometry/trajectory.h"
#include "core/random.h"

namespace mapbed {

// `truth` is world_from_robot, empty where nobody knows it: for faults that need to know how the
// robot moved. It is not changed: a broken log is judged by what was true.
using ConfiguredFault = Configured<BrokenLog(SensorLog, const Trajectory& truth, Rng)>;

// Something that goes wrong with logs. A new one is a file pair in this folder and a line in the
// table.
struct Fault {
  std::string name;  // its options are faults.NAME.…
  std::string about;
  std::vector<RemarkKind> told_as;  // remarks of these kinds name it rightly
  std::function<ConfiguredFault(const Settings&)> configure;
};

// In the order in which they are put into a log that has several.
const std::vector<Fault>& faults();

// Throws InputError for an unknown name.
const Fault& fault_by_name(const std::string& name, const SourceLocation& place = {});

// Those that a scenario's settings name, bound.
struct PlannedFaults {
  struct Planned {
    std::string name;
    std::vector<RemarkKind> told_as;
    ConfiguredFault fault;
  };
  std::string complete_yaml;  // faults.NAME.OPTION: value; empty where none are named
  std::vector<Planned> planned;
};

// Of settings whose paths begin with "faults.". Throws InputError.
PlannedFaults plan_faults(const Settings& settings);

// A fault as it is in a log.
struct FaultInLog {
  std::string name;
  std::vector<RemarkKind> told_as;
  std::vector<TimeInterval> when;  // empty: it found no place in this log
};

struct FaultyLog {
  SensorLog log;
  std::vector<FaultInLog> faults;  // as planned
};

// With the log's generator, of which each fault has a stream of its own.
FaultyLog broken(SensorLog log, const Trajectory& truth, const PlannedFaults& faults,
                 const Rng& rng);

}  // namespace mapbed
