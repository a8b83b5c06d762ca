#pragma once

#include <cstddef>
#include <string>

#include "bench/cli/interrupt.h"
#include "bench/cli/progress.h"
#include "bench/scenario/run_scenario.h"

namespace mapbed {

// What `mapbed run` tells of a scenario's runs on the way and in the end.

// What `work` gives, while its progress is shown; Ctrl-C ends it.
template <class Work>
auto while_working(const std::string& id, std::size_t runs, const Work& work) {
  const InterruptGuard interrupt;
  Progress progress(id, runs);
  return work([&](std::size_t done, std::size_t) {
    progress.advance_to(done);
    return !interrupt.was_interrupted();
  });
}

// Both give the exit status. The result that is finished gets its page; `strict` judges its claims.
int tell_interrupted(std::size_t done, std::size_t all);
int tell_finished(const ScenarioRun& run, const std::string& folder, bool strict);

}  // namespace mapbed
