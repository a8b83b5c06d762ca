#include "bench/scenario/run_scenario.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/process/folder_lock.h"
#include "bench/process/provenance.h"
#include "bench/results/judge.h"
#include "bench/results/result_folder.h"
#include "bench/results/result_tables.h"
#include "bench/results/run_files.h"
#include "bench/results/summary.h"
#include "bench/scenario/config_text.h"
#include "bench/scenario/journal.h"
#include "bench/scenario/runner.h"
#include "core/check.h"
#include "core/file/atomic_file.h"
#include "core/file/hash.h"
#include "core/file/text_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

constexpr const char* kProvenance = "provenance.json";

// The folder in which everything is kept until it is complete.
class Workshop {
 public:
  Workshop(const ScenarioPlan& plan, const ScenarioRunOptions& options, const std::string& identity)
      : plan_(plan), folder_(options.folder), inner_(options.folder + "/runs") {
    if (options.restart) fs::remove_all(inner_);
    std::error_code failed;
    fs::create_directories(inner_ / "files", failed);
    if (failed) throw InputError({inner_.string()}, "cannot be made: " + failed.message());
    fs::create_directories(inner_ / "tables");
    journal_.emplace((inner_ / "journal").string(), identity, plan.results.metrics.size());
  }

  Journal& journal() { return *journal_; }

  // Files first: a run that is in the journal is there with all it gave.
  void keep(const RunResult& result) {
    Results of_run = plan_.results;
    of_run.runs = {result.row};
    of_run.series = result.series;
    for (const ResultFile& file : result.files) {
      of_run.files.push_back(file_of_run(file, result.row, plan_.results));
      const fs::path path = inner_ / "files" / of_run.files.back().path;
      fs::create_directories(path.parent_path());
      write_file(path.string(), file.content);
    }
    write_table("series", result.row.run, series_csv(of_run));
    write_table("files", result.row.run, files_csv(of_run));
    journal_->append({result.row, result.cost});
  }

  // The series and the list of files of all runs that were kept, by this start or one before.
  void collect(Results& results) const {
    for (const RunRow& run : results.runs) {
      const std::string series = table_path("series", run.run);
      if (fs::exists(series)) {
        append(parse_series(series, read_text_file(series), results), results.series);
      }
      const std::string files = table_path("files", run.run);
      if (fs::exists(files)) append(parse_files(files, read_text_file(files)), results.files);
    }
  }

  // Everything to where it belongs; files that are not here any more were moved by a start that was
  // killed.
  void finish(const Results& results) {
    const fs::path files = inner_ / "files";
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(files)) {
      if (entry.is_regular_file()) found.push_back(entry.path());
    }
    for (const fs::path& path : found) {
      const fs::path target = folder_ / fs::relative(path, files);
      fs::create_directories(target.parent_path());
      fs::rename(path, target);
    }
    write_results(folder_.string(), results);
    journal_.reset();
    fs::remove_all(inner_);
  }

 private:
  template <class T>
  static void append(std::vector<T> more, std::vector<T>& all) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  std::string table_path(const std::string& kind, int run) const {
    return (inner_ / "tables" / fmt::format("{}_{}.csv", kind, run)).string();
  }
  void write_table(const std::string& kind, int run, const std::string& csv) const {
    if (!csv.empty()) write_file(table_path(kind, run), csv);
  }

  const ScenarioPlan& plan_;
  fs::path folder_;
  fs::path inner_;
  std::optional<Journal> journal_;
};

// What a finished result of the folder says it is of; empty where there is none.
std::string finished_identity(const std::string& folder) {
  std::ifstream file(fs::path(folder) / kProvenance);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("program")) return {};
  return json.value("runs_sha256", "") + json["program"].value("sha256", "");
}

// The runs of before as rows with level and variant; false numbers would be a broken journal.
std::set<int> take_over(const Journal& journal, const ScenarioPlan& plan, Results& results) {
  std::set<int> done;
  for (const Journal::Entry& entry : journal.found()) {
    if (entry.row.run < 0 || entry.row.run >= plan.runs()) continue;
    if (!done.insert(entry.row.run).second) continue;
    RunRow row = plan.row(entry.row.run);
    row.values = entry.row.values;
    row.failure = entry.row.failure;
    results.runs.push_back(std::move(row));
    results.costs.push_back(entry.cost);
  }
  return done;
}

void conclude(Results& results) {
  const auto by_number = [](const auto& a, const auto& b) { return a.run < b.run; };
  std::sort(results.runs.begin(), results.runs.end(), by_number);
  std::sort(results.costs.begin(), results.costs.end(), by_number);
  std::stable_sort(results.series.begin(), results.series.end(), by_number);
  std::stable_sort(results.files.begin(), results.files.end(), by_number);
  results.summary = summarise(results);
  results.verdicts = judge_all(results);
}

Provenance provenance_of(const ScenarioPlan& plan, const ScenarioRunOptions& options,
                         const ScenarioRun& run) {
  Provenance p;
  p.command = options.command;
  p.runs_sha256 = sha256(identity_text(plan));
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
  return p;
}

// A finished result of these very runs and this program, with the words, plots and claims of now.
ScenarioRun finished_run(const ScenarioPlan& plan, const std::string& folder) {
  ScenarioRun run{.results = plan.results, .complete = true};
  Results found = load_results(folder);
  run.results.runs = std::move(found.runs);
  run.results.costs = std::move(found.costs);
  run.results.series = std::move(found.series);
  run.results.files = std::move(found.files);
  run.results.provenance_json = std::move(found.provenance_json);
  run.done_before = static_cast<int>(run.results.runs.size());
  conclude(run.results);
  write_results(folder, run.results);
  fs::remove_all(fs::path(folder) / "runs");
  return run;
}

}  // namespace

ScenarioRun run_scenario(
    const ScenarioPlan& plan, const ScenarioRunOptions& options,
    const std::function<bool(std::size_t done, std::size_t total)>& may_go_on) {
  const Clock::time_point start = Clock::now();
  const FolderLock lock(options.folder);
  const std::string identity = sha256(identity_text(plan)) + sha256_of_program();
  if (!options.restart && finished_identity(options.folder) == identity) {
    return finished_run(plan, options.folder);
  }
  Workshop workshop(plan, options, identity);
  ScenarioRun run{.results = plan.results};
  const std::set<int> done = take_over(workshop.journal(), plan, run.results);
  run.done_before = static_cast<int>(done.size());
  std::vector<int> to_do;
  const std::vector<int> all = plan.runs_to_do();
  for (const int i : all) {
    if (!done.contains(i)) to_do.push_back(i);
  }

  const std::size_t total = all.size();
  std::atomic<bool> goes_on = true;
  RunnerCalls calls;
  calls.may_go_on = [&goes_on] { return goes_on.load(); };
  calls.done = [&](RunResult result) {
    workshop.keep(result);
    run.results.runs.push_back(std::move(result.row));
    run.results.costs.push_back(result.cost);
    if (!may_go_on(run.results.runs.size(), total)) goes_on = false;
  };
  if (!may_go_on(run.results.runs.size(), total)) goes_on = false;
  run.recordings = do_runs(plan, to_do, options.threads, calls);
  run.complete = run.results.runs.size() == total;
  if (!run.complete) return run;

  workshop.collect(run.results);
  conclude(run.results);
  Provenance provenance = provenance_of(plan, options, run);
  provenance.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  run.results.provenance_json = to_json(provenance);
  workshop.finish(run.results);
  return run;
}

RunRow repeat_run(const ScenarioPlan& plan, int run) {
  CHECK(run >= 0 && run < plan.runs());
  RunRow row;
  const RunnerCalls calls{[&row](RunResult result) { row = std::move(result.row); },
                          [] { return true; }};
  do_runs(plan, {run}, 1, calls);
  return row;
}

}  // namespace mapbed
