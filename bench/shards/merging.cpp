#include "bench/shards/merging.h"

#include <algorithm>
#include <set>

#include "bench/process/folder_lock.h"
#include "bench/results/result_folder.h"
#include "bench/scenario/publication.h"
#include "bench/scenario/staging_folder.h"
#include "bench/shards/shard_folders.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// Takes over what the shards have done, at which nobody works, and does the rest.
ScenarioRun run_locked(const ScenarioPlan& plan, ScenarioRunOptions options,
                       const MayGoOn& may_go_on) {
  for (const Shard& shard : shards_in(options.folder)) {
    options.taken_over.push_back(staging_of(shard));
  }
  ScenarioRun run = run_locked_scenario(plan, options, may_go_on);
  if (run.complete) discard_shards(options.folder, identity_of_runs(plan));
  return run;
}

bool are_all_in(const ScenarioPlan& plan, const std::string& folder) {
  const std::set<int> in = runs_in_all(folder, plan);
  const std::vector<int> runs = plan.runs_to_do();
  return std::includes(in.begin(), in.end(), runs.begin(), runs.end());
}

}  // namespace

bool is_finished(const ScenarioPlan& plan, const std::string& folder) {
  return finished_identity(folder) == identity_of_runs(plan);
}

void check_folder(const ScenarioPlan& plan, const ScenarioRunOptions& options) {
  refuse_foreign_files(options.folder, plan.results);
  const std::string identity = identity_of_runs(plan);
  if (options.restart) remove_other_runs(options.folder, identity);
  refuse_other_runs(options.folder, identity);
}

ScenarioRun finished_result(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                            const MayGoOn& may_go_on) {
  if (options.restart) {
    throw InputError({options.folder}, "all runs of this result are done",
                     "--restart without --shard and --slurm does them again");
  }
  ScenarioRun run = run_locked_scenario(plan, options, may_go_on);
  discard_shards(options.folder, identity_of_runs(plan));
  return run;
}

std::optional<ScenarioRun> merge_if_all_in(const ScenarioPlan& plan,
                                           const ScenarioRunOptions& given,
                                           const MayGoOn& may_go_on) {
  ScenarioRunOptions options = given;
  options.restart = false;  // was for the beginning
  std::optional<FolderLock> lock;
  try {
    lock.emplace(options.folder, kPatience);
  } catch (const InputError&) {  // somebody has the folder for long, and merges
    return std::nullopt;
  }
  finish_publication(options.folder);
  if (is_finished(plan, options.folder)) return finished_result(plan, options, may_go_on);
  const bool is_last = !is_any_busy(options.folder) && are_all_in(plan, options.folder);
  if (!is_last) return std::nullopt;
  return run_locked(plan, options, may_go_on);
}

ScenarioRun run_all_shards(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                           const MayGoOn& may_go_on) {
  const FolderLock lock(options.folder);
  finish_publication(options.folder);
  if (!options.restart && is_finished(plan, options.folder)) {
    return finished_result(plan, options, may_go_on);
  }
  refuse_busy_shards(options.folder);
  if (options.restart) {
    remove_shards(options.folder);
  } else {
    refuse_other_runs(options.folder, identity_of_runs(plan));
  }
  return run_locked(plan, options, may_go_on);
}

}  // namespace mapbed
