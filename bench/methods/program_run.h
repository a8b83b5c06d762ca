#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/estimator.h"
#include "bench/methods/program_method.h"
#include "core/interrupted.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// What a method needed, all programs and threads of it together.
struct MethodCost {
  double wall_seconds = 0.0;       // [s]
  double processor_seconds = 0.0;  // [s]
  double peak_memory = 0.0;        // [bytes] of its largest process; 0: it has none of its own
};

struct ProgramRun {
  Estimate estimate;
  MethodCost cost;
  // Name and content of the files that it was to keep, as far as it wrote them.
  std::vector<std::pair<std::string, std::string>> kept;
};

// A program that gave no trajectory for the log: how it ended, or what is wrong with what it wrote.
class ProgramFailed : public InputError {
 public:
  ProgramFailed(const std::string& reason, std::string said)
      : InputError(reason), messages(std::move(said)) {}

  std::string messages;  // what it wrote to standard output and error, the end of it
};

// Runs it on a log as the robot recorded it. Its estimate has a pose for each scan of `prepared`,
// which is what methods of ours get of that log: interpolated between the program's own, and none
// before its first and after its last one. Throws ProgramFailed, Interrupted where `goes_on` says
// no, and InputChanged where a file that the method is made of is another one now.
ProgramRun run_program_method(const ProgramMethod& method, const SensorLog& as_recorded,
                              const SensorLog& prepared, std::uint64_t seed,
                              const GoesOn& goes_on = {});

// The poses of the scans of `log`, those of tilted lasers left out. Throws InputError, which begins
// with `name`, where the path has a pose for less than nine in ten of them.
Estimate estimate_at_scans(const std::string& name, const Trajectory& path, const SensorLog& log);

}  // namespace mapbed
