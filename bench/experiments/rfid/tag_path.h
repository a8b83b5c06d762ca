#pragma once

#include <string>

#include "bench/methods/chosen_method.h"
#include "bench/sources/run_input.h"

namespace mapbed {

// The path from which tags are mapped, laid onto the true one.
struct TagPath {
  Trajectory world_from_robot;
  double error = 0.0;  // [m] RMS of its positions
};

// That of a method that knows nothing of tags; the same for all runs of a seed and a log, which
// share it. "truth": the true one itself.
TagPath tag_path(const std::string& estimator, const ChosenMethod& method, const RunInput& input,
                 const LogInput& drive);

// What stands for a method's name there.
inline constexpr const char* kTruePath = "truth";

}  // namespace mapbed
