#pragma once

#include <string>
#include <vector>

#include "bench/scenario/run_scenario.h"
#include "bench/shards/shard.h"

namespace mapbed {

// What `mapbed run` does where several programs share the runs. All give the exit status; whoever
// finds that all runs are in tells of the result as `mapbed run` alone does, and `strict` judges
// its claims.

// --shard: does that part.
int do_shard(const ScenarioPlan& plan, const ScenarioRunOptions& options, const Shard& shard,
             bool strict);

// --slurm: submits so many shards, with options of sbatch.
int do_slurm(const ScenarioPlan& plan, const ScenarioRunOptions& options, int shards,
             const std::vector<std::string>& sbatch, bool strict);

// --status: kInterrupted as long as runs are missing, so that a script can wait for them.
int do_status(const ScenarioPlan& plan, const ScenarioRunOptions& options, bool strict);

}  // namespace mapbed
