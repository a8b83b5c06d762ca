#include "bench/scenario/run_scenario.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "bench/process/folder_lock.h"
#include "bench/process/provenance.h"
#include "bench/process/stopwatch.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"
#include "bench/results/summary.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/journal.h"
#include "bench/scenario/publication.h"
#include "bench/scenario/runner.h"
#include "bench/scenario/staging_folder.h"
#include "core/check.h"
#include "core/file/hash.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// The runs of before as rows with level and variant; other numbers would be a broken journal.
std::set<int> resume(const std::vector<Journal::Entry>& found, const ScenarioPlan& plan,
                     const std::vector<int>& wanted, Results& results) {
  const std::set<int> numbers(wanted.begin(), wanted.end());
  std::set<int> done;
  for (const Journal::Entry& entry : found) {
    if (!numbers.contains(entry.row.run)) continue;
    if (!done.insert(entry.row.run).second) continue;
    RunRow row = plan.row(entry.row.run);
    row.values = entry.row.values;
    row.failure = entry.row.failure;
    results.runs.push_back(std::move(row));
    results.costs.push_back(entry.cost);
  }
  return done;
}

// Everything in the order of the runs, the summary and what it says of the claims.
void summarize(Results& results) {
  const auto by_number = [](const auto& a, const auto& b) { return a.run < b.run; };
  std::sort(results.runs.begin(), results.runs.end(), by_number);
  std::sort(results.costs.begin(), results.costs.end(), by_number);
  std::stable_sort(results.series.begin(), results.series.end(), by_number);
  std::stable_sort(results.files.begin(), results.files.end(), by_number);
  results.summary = summary_of(results);
  results.verdicts = judge_all(results);
}

Provenance provenance_of(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                         const ScenarioRun& run) {
  Provenance p;
  p.command = options.command;
  p.runs_sha256 = identity_of(plan);
  p.program_sha256 = sha256_of_program();
  p.seed = plan.scenario.seed;
  p.runs = static_cast<int>(run.results.runs.size());
  p.runs_done_before = run.done_before;
  p.recordings_needed = recordings_needed(plan);
  p.recordings_made = run.recordings;
  p.threads = options.threads;
  for (const CostRow& cost : run.results.costs) {
    p.processor_seconds += cost.seconds + cost.recording_seconds;
  }
  for (const ResultFile& table : tables_of_runs(run.results)) {
    if (!table.content.empty()) p.tables_sha256.emplace_back(table.path, sha256(table.content));
  }
  return p;
}

// Rows by hand are no result of this plan: each run once, with its seed, level and variant.
void check_rows(const Results& found, const ScenarioPlan& plan, const std::string& folder) {
  const std::vector<int> planned = plan.runs_to_do();
  bool fits = found.runs.size() == planned.size() && found.costs.size() == planned.size();
  for (std::size_t i = 0; fits && i < planned.size(); ++i) {
    const RunRow expected = plan.row(planned[i]);
    const RunRow& row = found.runs[i];
    fits = row.run == expected.run && row.seed == expected.seed && row.level == expected.level &&
           row.variant == expected.variant && found.costs[i].run == expected.run;
  }
  if (fits) return;
  throw InputError({(fs::path(folder) / "runs.csv").string()},
                   fmt::format("has not each of the {} runs once, as planned", planned.size()),
                   "--restart makes all runs again, --out chooses another folder");
}

// A finished result of these very runs and this program, with the words, plots and claims of now.
ScenarioRun finished_run(const ScenarioPlan& plan, const std::string& folder,
                         const std::string& identity) {
  ScenarioRun run{.results = plan.results, .complete = true};
  Results found = load_results(folder);
  refuse_foreign_files(folder, plan.results);
  check_rows(found, plan, folder);
  run.results.runs = std::move(found.runs);
  run.results.costs = std::move(found.costs);
  run.results.series = std::move(found.series);
  run.results.files = std::move(found.files);
  run.results.provenance_json = std::move(found.provenance_json);
  run.done_before = static_cast<int>(run.results.runs.size());
  summarize(run.results);
  publish(folder, run.results);
  discard_staging(folder, identity);
  return run;
}

}  // namespace

ScenarioRun staged_runs(const ScenarioPlan& plan, const std::vector<int>& runs, int threads,
                        StagingFolder& staging, const MayGoOn& may_go_on) {
  ScenarioRun run{.results = plan.results};
  const std::set<int> done = resume(staging.found(), plan, runs, run.results);
  run.done_before = static_cast<int>(done.size());
  std::vector<int> to_do = runs;
  const std::size_t total = to_do.size();
  std::erase_if(to_do, [&done](int i) { return done.contains(i); });

  bool goes_on = true;  // once it does not, it never does again
  std::mutex asking;
  RunnerCalls calls;
  calls.may_go_on = [&] {
    const std::scoped_lock lock(asking);
    goes_on = goes_on && may_go_on(run.results.runs.size(), total);
    return goes_on;
  };
  calls.done = [&](RunResult result) {
    staging.commit(result);
    const std::scoped_lock lock(asking);
    run.results.runs.push_back(std::move(result.row));
    run.results.costs.push_back(result.cost);
    goes_on = goes_on && may_go_on(run.results.runs.size(), total);
  };
  calls.remark = [&](const std::string& remark) { run.remarks.push_back(remark); };
  run.recordings = do_runs(plan, to_do, threads, calls);
  std::sort(run.remarks.begin(), run.remarks.end());
  run.complete = run.results.runs.size() == total;
  return run;
}

std::string identity_of_runs(const ScenarioPlan& plan) {
  return identity_of(plan) + sha256_of_program();
}

ScenarioRun run_scenario(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                         const MayGoOn& may_go_on) {
  const FolderLock lock(options.folder);
  return run_locked_scenario(plan, options, may_go_on);
}

ScenarioRun run_locked_scenario(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                                const MayGoOn& may_go_on) {
  const Stopwatch stopwatch;
  finish_publication(options.folder);
  const std::string identity = identity_of_runs(plan);
  if (!options.restart && finished_identity(options.folder) == identity) {
    return finished_run(plan, options.folder, identity);
  }
  refuse_foreign_files(options.folder, plan.results);
  StagingFolder staging(options.folder, plan.results, identity, options.restart);
  for (const std::string& other : options.taken_over) {
    staging.take_over({options.folder, plan.results, identity, false, other});
  }
  ScenarioRun run = staged_runs(plan, plan.runs_to_do(), options.threads, staging, may_go_on);
  if (!run.complete) return run;
  staging.collect(run.results);
  summarize(run.results);
  Provenance provenance = provenance_of(plan, options, run);
  provenance.wall_seconds = stopwatch.seconds();
  run.results.provenance_json = to_json(provenance);
  staging.finish(run.results);
  return run;
}

RunResult repeat_run(const ScenarioPlan& plan, int run, const RepeatOptions& options) {
  CHECK(run >= 0 && run < plan.runs());
  std::optional<RunResult> repeated;
  RunnerCalls calls;
  calls.done = [&repeated](RunResult result) { repeated = std::move(result); };
  calls.may_go_on = options.goes_on ? options.goes_on : [] { return true; };
  calls.alone = true;
  calls.viewer = options.viewer;
  do_runs(plan, {run}, options.threads, calls);
  if (!repeated) throw Interrupted();
  return *std::move(repeated);
}

}  // namespace mapbed
