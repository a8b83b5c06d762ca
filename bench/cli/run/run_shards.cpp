#include "bench/cli/run/run_shards.h"

#include <algorithm>

#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/cli/run/run_told.h"
#include "bench/scenario/staging_folder.h"
#include "bench/shards/merging.h"
#include "bench/shards/shard_folders.h"
#include "bench/shards/shard_run.h"
#include "bench/shards/submission.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

void print_state(const std::string& id, const ShardsState& state) {
  fmt::print("{}: {} of {} runs are in\n", id, state.in, state.all);
  for (const ShardState& of : state.shards) {
    fmt::print("shard {:<9} {} of {} runs, {}\n", text_of(of.shard), of.done, of.runs, of.state);
  }
  if (!state.job.empty()) fmt::print("submitted as job {}\n", state.job);
  if (!state.remark.empty()) fmt::print("remark: {}\n", state.remark);
}

// A finished result that another program made, or another configuration: nothing is missing there,
// and nothing of this plan is in.
void refuse_other_result(const ScenarioPlan& plan, const std::string& folder) {
  const bool is_of_other = !finished_identity(folder).empty() && !is_finished(plan, folder);
  if (!is_of_other || !shards_in(folder).empty()) return;
  throw InputError({folder},
                   "holds the finished result of another version of the program, of the scenario "
                   "or of its settings, and no shard has begun to make it anew",
                   "start shards where it shall be made anew");
}

// The first one that has to be started, again or at all.
void print_remedy(const ShardsState& state) {
  const auto idle = std::find_if(state.shards.begin(), state.shards.end(),
                                 [](const ShardState& of) { return of.is_idle; });
  if (idle == state.shards.end()) return;
  fmt::print("start what is not at work with --slurm {}, or --shard {}; runs that are in stay\n",
             idle->shard.count, text_of(idle->shard));
}

}  // namespace

int do_shard(const ScenarioPlan& plan, const ScenarioRunOptions& options, const Shard& shard,
             bool strict) {
  const ShardRun run = while_working(
      plan.scenario.id, runs_of(plan, shard).size(),
      [&](const MayGoOn& may_go_on) { return run_shard(plan, options, shard, may_go_on); });
  const int done = run.done_before + run.done;
  fmt::print("{}: shard {}: {} of {} runs, {} of them done before; of all shards {} of {} are in\n",
             plan.scenario.id, text_of(shard), done, run.runs, run.done_before, run.in, run.all);
  for (const std::string& remark : run.remarks) fmt::print("remark: {}\n", remark);
  if (run.merged && run.merged->complete) {
    return tell_finished(*run.merged, options.folder, strict);
  }
  if (done == run.runs && !run.merged) return kDone;
  return tell_interrupted(static_cast<std::size_t>(done), static_cast<std::size_t>(run.runs));
}

int do_slurm(const ScenarioPlan& plan, const ScenarioRunOptions& options, int shards,
             const std::vector<std::string>& sbatch, bool strict) {
  const ShardsState state =
      while_working(plan.scenario.id, plan.runs_to_do().size(), [&](const MayGoOn& may_go_on) {
        return submit_shards(plan, options, shards, sbatch, may_go_on);
      });
  if (state.merged && state.merged->complete) {
    return tell_finished(*state.merged, options.folder, strict);
  }
  print_state(plan.scenario.id, state);
  return kDone;
}

int do_status(const ScenarioPlan& plan, const ScenarioRunOptions& options, bool strict) {
  refuse_other_result(plan, options.folder);
  const ShardsState state = while_working(
      plan.scenario.id, plan.runs_to_do().size(),
      [&](const MayGoOn& may_go_on) { return state_of_shards(plan, options, may_go_on); });
  if (state.merged && state.merged->complete) {
    return tell_finished(*state.merged, options.folder, strict);
  }
  print_state(plan.scenario.id, state);
  print_remedy(state);
  return kInterrupted;
}

}  // namespace mapbed
