#include "bench/shards/submission.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "bench/process/folder_lock.h"
#include "bench/scenario/publication.h"
#include "bench/scenario/staging_folder.h"
#include "bench/shards/merging.h"
#include "bench/shards/shard_folders.h"
#include "bench/shards/slurm.h"
#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

const QueuedShard* found(const std::vector<QueuedShard>& queued, const Shard& shard) {
  const auto task = std::find_if(queued.begin(), queued.end(),
                                 [&](const QueuedShard& of) { return of.shard == shard; });
  return task == queued.end() ? nullptr : &*task;
}

// What a task of Slurm said in the end; empty where it said nothing.
std::string last_words(const std::string& folder, const Shard& shard) {
  const std::string path = (fs::path(folder) / messages_of(shard)).string();
  if (!fs::exists(path)) return "";
  const std::string text = read_text_file(path);
  std::string last;
  for (std::string_view left = text; !left.empty();) {
    const std::string_view line = next_line(left);
    if (!line.empty()) last = line;
  }
  return last.empty() ? "" : fmt::format("; {} ends with: {}", path, last);
}

std::string words_of(const std::string& folder, const ShardState& of, const QueuedShard* task) {
  if (of.done == of.runs) return "done";
  if (task != nullptr) return task->state;
  if (is_busy(folder, of.shard)) return "at work";
  return of.done > 0 ? "stopped" : "not begun";
}

// Of the shards of one division. The folder is locked.
void add_shards(const ScenarioPlan& plan, const std::string& folder, int count,
                const std::vector<QueuedShard>& queued, ShardsState& state) {
  const std::set<int> in = runs_in_all(folder, plan);
  const std::vector<std::vector<int>> all = runs_of_all(plan, count);
  for (int index = 1; index <= count; ++index) {
    const std::vector<int>& runs = all[static_cast<std::size_t>(index - 1)];
    ShardState of{{index, count}};
    of.runs = static_cast<int>(runs.size());
    of.done = static_cast<int>(
        std::count_if(runs.begin(), runs.end(), [&](int run) { return in.contains(run); }));
    of.state = words_of(folder, of, found(queued, of.shard));
    of.is_idle = of.state == "stopped" || of.state == "not begun";
    state.shards.push_back(of);
  }
  state.in = static_cast<int>(in.size());
}

void refuse_other_division(const std::vector<QueuedShard>& queued, int shards) {
  for (const QueuedShard& task : queued) {
    if (task.shard.count == shards) continue;
    throw InputError(
        {},
        fmt::format("Slurm has {} shards of this result in its queue already", task.shard.count),
        fmt::format("say --slurm {}, or end them with scancel", task.shard.count));
  }
}

// What Slurm tells of what was submitted to it; where it does not, the journals tell enough.
std::vector<QueuedShard> queued_if_told(const std::string& folder, ShardsState& state) try {
  const bool was_submitted = fs::exists(fs::path(folder) / kSlurmFiles);
  return was_submitted && has_slurm() ? queued_in_slurm(folder) : std::vector<QueuedShard>{};
} catch (const InputError& error) {
  state.remark = error.what();
  return {};
}

ShardsState of_finished(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                        const MayGoOn& may_go_on) {
  ShardsState state{.all = static_cast<int>(plan.runs_to_do().size())};
  state.in = state.all;
  state.merged = finished_result(plan, options, may_go_on);
  return state;
}

void merge(const ScenarioPlan& plan, const ScenarioRunOptions& options, const MayGoOn& may_go_on,
           ShardsState& state) {
  if (state.in == state.all) state.merged = merge_if_all_in(plan, options, may_go_on);
}

// The command of a task, which works where this program does.
std::vector<std::string> command_of_task(const ScenarioRunOptions& options) {
  std::vector<std::string> command = options.command;
  command.front() = fs::canonical("/proc/self/exe").string();
  command.insert(command.end(), {"--out", fs::canonical(options.folder).string()});
  return command;
}

// Those that have runs to do, which nobody does. Their folders are there before their tasks are,
// which may see those of others late. Gives the number of the job; empty where there is none.
std::string submit_idle(ShardSubmission submission, ShardsState& state) {
  std::vector<ShardState*> idle;
  for (ShardState& of : state.shards) {
    if (!of.is_idle) continue;
    idle.push_back(&of);
    submission.shards.push_back(of.shard);
    fs::create_directories(fs::path(submission.folder) / folder_of(of.shard));
  }
  if (idle.empty()) return "";
  std::string job;
  try {
    job = submit_to_slurm(submission);
  } catch (const InputError&) {
    remove_unused(submission.folder);
    throw;
  }
  for (ShardState* of : idle) of->state = "submitted";
  return job;
}

}  // namespace

ShardsState submit_shards(const ScenarioPlan& plan, const ScenarioRunOptions& options, int shards,
                          const std::vector<std::string>& sbatch_options,
                          const MayGoOn& may_go_on) {
  check_sbatch_options(sbatch_options);
  std::optional<FolderLock> lock(std::in_place, options.folder, kPatience);
  finish_publication(options.folder);
  if (is_finished(plan, options.folder)) return of_finished(plan, options, may_go_on);
  const std::vector<QueuedShard> queued = queued_in_slurm(options.folder);
  refuse_other_division(queued, shards);
  check_folder(plan, options);
  if (options.restart) {
    remove_shards(options.folder);
    discard_staging(options.folder, identity_of_runs(plan));
  }
  ShardsState state{.all = static_cast<int>(plan.runs_to_do().size())};
  add_shards(plan, options.folder, shards, queued, state);
  state.job = submit_idle({.folder = options.folder,
                           .command = command_of_task(options),
                           .processors = options.threads,
                           .options = sbatch_options},
                          state);
  lock.reset();
  merge(plan, options, may_go_on, state);
  return state;
}

ShardsState state_of_shards(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                            const MayGoOn& may_go_on) {
  std::optional<FolderLock> lock(std::in_place, options.folder, kPatience);
  finish_publication(options.folder);
  if (is_finished(plan, options.folder)) return of_finished(plan, options, may_go_on);
  refuse_other_runs(options.folder, identity_of_runs(plan));
  ShardsState state{.all = static_cast<int>(plan.runs_to_do().size())};
  const std::vector<QueuedShard> queued = queued_if_told(options.folder, state);
  std::set<int> counts;
  for (const Shard& shard : shards_in(options.folder)) counts.insert(shard.count);
  state.in = static_cast<int>(runs_in_all(options.folder, plan).size());
  for (const int count : counts) add_shards(plan, options.folder, count, queued, state);
  for (ShardState& of : state.shards) {
    if (of.is_idle) of.state += last_words(options.folder, of.shard);
  }
  lock.reset();
  merge(plan, options, may_go_on, state);
  return state;
}

}  // namespace mapbed
