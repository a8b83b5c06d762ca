#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "bench/faults/faults.h"
#include "bench/sources/run_input.h"
#include "bench/sources/shared_work.h"
#include "bench/sources/simulate.h"
#include "core/config/settings.h"
#include "core/file/input_file.h"
#include "core/interrupted.h"
#include "core/log/log_options.h"

// Where the log of a run comes from: it is planned once, from the settings; opened, so recorded or
// read, once for all runs that share it; and gives each of these what it works on, with noise and
// faults of its own.

namespace mapbed {

// A log in a file, or in the files of a folder.
struct RecordedPlan {
  std::string path;
  InputFiles log = {};
  LogOptions options = {};
  // Where people measured how the robot moved, and poses that reach their stamps; none: nobody did.
  std::optional<InputFile> relations;
  std::optional<InputFile> relations_odometry;
  // Where nobody did: a path that another program found.
  std::optional<InputFile> reference = {};
};

// Settings of a source, bound: robot, sensors, world and description of the log were read when this
// was made, and are not read again.
struct SourcePlan {
  std::string complete_yaml;    // all options, for the record
  std::string clean_yaml = {};  // the same without faults
  InputFiles files = {};        // all that the source is made of
  // Two runs with the same key and seed share a recording.
  std::string key;
  bool depends_on_seed = true;  // false: a recorded log
  // Why there is nothing to work on: "the log 'intel' is not here (intel/intel.clf.gz)". Not an
  // error, for recorded logs are no part of the program. Empty: it is here.
  std::string missing = {};
  std::variant<PreparedSimulation, RecordedPlan> origin = {};
  PlannedFaults faults = {};

  bool is_simulated() const { return std::holds_alternative<PreparedSimulation>(origin); }
};

// What was read, built or hashed for one plan and serves the next ones too.
struct SourceParts {
  SimulationParts simulation;
  HashedFiles files;
};

// Throws InputError.
SourcePlan plan_source(const Settings& settings, SourceParts& parts);

// Whether the true path is known; a recorded log is read to see.
bool has_truth(const SourcePlan& plan);

// A log in memory.
class LogSource {
 public:
  virtual ~LogSource() = default;
  virtual double recorded_seconds() const = 0;
  virtual std::string remark() const { return {}; }  // that its robot got stuck; else empty
  // With the noise and the faults of `plan`, which has the key of the one that was opened, drawn by
  // `seed`. For several threads at a time; what it gives refers to this source.
  LogInput input(const SourcePlan& plan, std::uint64_t seed) const;

 private:
  virtual LogInput clean_input(const SourcePlan& plan, std::uint64_t seed) const = 0;

  mutable SharedWorks shared_;
};

// Records or reads it. The plan must outlive the source. Throws Interrupted where it is not to go
// on.
std::unique_ptr<LogSource> open_source(const SourcePlan& plan, std::uint64_t seed,
                                       const GoesOn& goes_on = {});

// Of settings without 'log'. Throws InputError.
SimulationPlan simulation_plan(const Settings& settings);

}  // namespace mapbed
