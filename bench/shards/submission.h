#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/scenario/run_scenario.h"
#include "bench/shards/shard.h"

namespace mapbed {

// How far a shard is.
struct ShardState {
  Shard shard;
  int done = 0;  // of its runs, whoever did them
  int runs = 0;
  std::string state = {};  // in words
  bool is_idle = false;    // has runs to do, and nobody does or will do them
};

struct ShardsState {
  int in = 0;   // runs of all shards that are done
  int all = 0;  // runs
  std::vector<ShardState> shards = {};
  std::string job = {};                    // that was submitted now; empty: there was no need
  std::string remark = {};                 // why the queue is not known
  std::optional<ScenarioRun> merged = {};  // where all are in
};

// Submits to Slurm those of so many shards that have runs to do and are not in its queue; each is
// done by the command of the options, with --out and --shard behind it. Merges where nothing is to
// be done. Throws InputError where shards of another division are waiting, where Slurm is not there
// or refuses, and what run_shard throws before its work.
ShardsState submit_shards(const ScenarioPlan& plan, const ScenarioRunOptions& options, int shards,
                          const std::vector<std::string>& sbatch_options, const MayGoOn& may_go_on);

// How far all shards are, by their journals and the queue of Slurm where there is one; merges where
// all are in and nobody is at work.
ShardsState state_of_shards(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                            const MayGoOn& may_go_on);

}  // namespace mapbed
