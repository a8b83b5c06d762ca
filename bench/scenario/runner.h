#pragma once

#include <functional>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"
#include "bench/scenario/plan.h"
#include "core/interrupted.h"

namespace mapbed {

class RunViewer;

struct RunResult {
  RunRow row;
  CostRow cost;
  std::vector<ResultFile> files = {};
  std::vector<Series> series = {};  // in the order of Results::series_metrics; some may be missing
};

// What the runner tells, one thread at a time, and asks, from several.
struct RunnerCalls {
  std::function<void(RunResult)> done;  // a run is over; throws to stop everything
  GoesOn may_go_on;                     // false: nothing more is started, and no log read on
  std::function<void(const std::string&)> remark = {};  // of a recording that runs share
  bool alone = false;  // a run is done again by itself, with all files that there can be of it
  RunViewer* viewer = nullptr;  // where a single run is done: looks at its method at work
};

// Does the runs of these numbers, `threads` at a time at most; runs that share a recording share
// it, and no more recordings are in memory than there are threads. Runs that fail are told like
// others. Gives the number of recordings that were made.
int do_runs(const ScenarioPlan& plan, const std::vector<int>& runs, int threads,
            const RunnerCalls& calls);

// Those of the runs of these numbers that work on one recording, in the order of the first of them.
std::vector<std::vector<int>> sharing_recordings(const ScenarioPlan& plan,
                                                 const std::vector<int>& runs);

// How many recordings all runs of the scenario need.
int recordings_needed(const ScenarioPlan& plan);

}  // namespace mapbed
