#pragma once

#include <memory>
#include <string>

#include "bench/experiments/experiment.h"
#include "bench/sources/simulate.h"
#include "core/config/settings.h"

namespace mapbed {

// Where the log of a run comes from. Settings that are about that (world, robot, path, people, log
// and what stands below them, simulation.…, driver.…, recorder.…), and all others.
struct DividedSettings {
  Settings source;
  Settings experiment;
};
DividedSettings divided(const Settings& settings);

// What is known before anything is recorded.
struct SourcePlan {
  std::string complete_yaml;  // all options, for the record
  // Two runs with the same key and seed share a recording.
  std::string key;
  bool depends_on_seed = true;  // false: a recorded log
  // Why there is nothing to work on: "the log 'intel' is not here (intel/intel.clf.gz)". Not an
  // error, for recorded logs are no part of the program. Empty: it is here.
  std::string missing = {};
  std::shared_ptr<const PreparedSimulation> simulation = {};  // none: a recorded log
  Settings settings = {};                                     // of the recorded log
};
// Parts that were read or built for one plan serve the next ones too. Throws InputError.
SourcePlan plan_source(const Settings& settings, SimulationParts& parts);
SourcePlan plan_source(const Settings& settings);

// A log that several runs share: it is recorded, or read, once. Noise is drawn for each run.
class LogSource {
 public:
  virtual ~LogSource() = default;
  virtual double recorded_seconds() const = 0;
  // Noise as `plan` has it, drawn by `seed`. For several threads at a time.
  virtual RunInput input(const SourcePlan& plan, std::uint64_t seed) const = 0;
};

// Of settings without 'log'. Throws InputError.
SimulationPlan simulation_plan(const Settings& settings);

std::unique_ptr<LogSource> open_source(const SourcePlan& plan, std::uint64_t seed);

}  // namespace mapbed
