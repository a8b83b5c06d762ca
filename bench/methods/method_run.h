#pragma once

#include <cstdint>
#include <functional>

#include "bench/methods/chosen_method.h"
#include "bench/methods/program_run.h"
#include "core/random.h"

namespace mapbed {

struct MethodInput {
  const SensorLog& as_recorded;  // what a program of somebody else's is given
  const SensorLog& prepared;     // what a method of ours is given
  Rng rng;                       // a method's of ours
  std::uint64_t seed = 0;        // a program's
  GoesOn goes_on = {};           // asked while a program runs
  Given given = {};              // to a method of ours
};

// Looks at a method of ours at work; a program shows nothing before it is done.
struct MethodWatch {
  std::function<void(const Measurement&, const Estimator&)> before = {};  // it is added
  std::function<void(const Measurement&, const Estimator&)> after = {};
  std::function<void(const Estimator&)> all_added = {};
};

struct MethodRun {
  Estimate estimate;
  MethodCost cost;
  std::vector<std::pair<std::string, std::string>> kept = {};  // as ProgramRun::kept
};

// The whole log through the method. Throws ProgramFailed, and Interrupted.
MethodRun run_method(const ChosenMethod& method, const MethodInput& input,
                     const MethodWatch& watch = {});

}  // namespace mapbed
