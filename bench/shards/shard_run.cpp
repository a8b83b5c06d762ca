#include "bench/shards/shard_run.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <thread>

#include "bench/process/folder_lock.h"
#include "bench/process/stopwatch.h"
#include "bench/scenario/publication.h"
#include "bench/scenario/staging_folder.h"
#include "bench/shards/merging.h"
#include "bench/shards/shard_folders.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// One that was ended a moment ago, perhaps on another machine, may have its lock still.
void wait_for(const std::string& folder, const Shard& shard) {
  const Stopwatch waited;
  while (is_busy(folder, shard) && waited.seconds() < kPatience) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

// Those of the shard that stand in no journal but its own.
std::vector<int> runs_left(const ScenarioPlan& plan, const std::string& folder,
                           const Shard& shard) {
  const std::set<int> own = runs_in((fs::path(folder) / staging_of(shard)).string(), plan);
  const std::set<int> all = runs_in_all(folder, plan);
  std::vector<int> runs = runs_of(plan, shard);
  std::erase_if(runs, [&](int run) { return all.contains(run) && !own.contains(run); });
  return runs;
}

// The lock of the shard, whose folder is made. The result's is locked.
void begin(const ScenarioPlan& plan, const ScenarioRunOptions& options, const Shard& shard,
           std::optional<FolderLock>& lock) {
  check_folder(plan, options);
  const std::string path = (fs::path(options.folder) / folder_of(shard)).string();
  std::error_code failed;
  fs::create_directories(path, failed);
  if (failed) throw InputError({path}, "cannot be made: " + failed.message());
  lock.emplace(path);
}

}  // namespace

ShardRun run_shard(const ScenarioPlan& plan, const ScenarioRunOptions& options, const Shard& shard,
                   const MayGoOn& may_go_on) {
  ShardRun result{.runs = static_cast<int>(runs_of(plan, shard).size()),
                  .all = static_cast<int>(plan.runs_to_do().size())};
  wait_for(options.folder, shard);
  std::optional<FolderLock> result_lock(std::in_place, options.folder, kPatience);
  finish_publication(options.folder);
  if (is_finished(plan, options.folder)) {
    result.merged = finished_result(plan, options, may_go_on);
    result.done_before = result.runs;
    result.in = result.all;
    return result;
  }
  std::optional<FolderLock> shard_lock;
  begin(plan, options, shard, shard_lock);
  const std::vector<int> runs = runs_left(plan, options.folder, shard);
  result_lock.reset();

  std::optional<StagingFolder> staging(std::in_place, options.folder, plan.results,
                                       identity_of_runs(plan), options.restart, staging_of(shard));
  const ScenarioRun run = staged_runs(plan, runs, options.threads, *staging, may_go_on);
  staging.reset();
  shard_lock.reset();
  result.done = static_cast<int>(run.results.runs.size()) - run.done_before;
  result.done_before = result.runs - static_cast<int>(runs.size()) + run.done_before;
  result.remarks = run.remarks;
  result.in = static_cast<int>(runs_in_all(options.folder, plan).size());
  if (run.complete) result.merged = merge_if_all_in(plan, options, may_go_on);
  if (result.merged) result.in = result.all;
  return result;
}

}  // namespace mapbed
