#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/scenario/run_scenario.h"
#include "bench/shards/shard.h"

namespace mapbed {

struct ShardRun {
  int runs = 0;         // of the shard
  int done_before = 0;  // of them
  int done = 0;         // of them, now
  int in = 0;           // of all shards: runs that are done
  int all = 0;
  std::vector<std::string> remarks = {};   // see ScenarioRun
  std::optional<ScenarioRun> merged = {};  // where this was the last shard, or all was done before
};

// Does the runs of a shard that nobody has done yet, into shards/ below the folder of the results;
// where all runs of the scenario are in then, merges them into the result, which has the bytes that
// run_scenario gives. Shards may be done at the same time by programs on several machines that
// share the folder. `restart` throws away what an earlier start of this shard has done, and all of
// another configuration or program. Throws InputError where such runs are in the way, where
// somebody does this shard already, or the whole scenario.
ShardRun run_shard(const ScenarioPlan& plan, const ScenarioRunOptions& options, const Shard& shard,
                   const MayGoOn& may_go_on);

}  // namespace mapbed
