#include "bench/scenario/run_scenario.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/process/folder_lock.h"
#include "bench/process/provenance.h"
#include "bench/results/cost_claims.h"
#include "bench/results/results_file.h"
#include "bench/results/summary.h"
#include "bench/scenario/config_text.h"
#include "bench/scenario/journal.h"
#include "bench/scenario/runner.h"
#include "core/check.h"
#include "core/file/atomic_file.h"
#include "core/file/hash.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

constexpr const char* kProvenance = "provenance.json";

// Of a text that becomes a part of a file's name.
std::string slug_of(const std::string& text) {
  std::string slug;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (plain) slug += c;
    if (!plain && !slug.empty() && slug.back() != '_') slug += '_';
  }
  while (!slug.empty() && slug.back() == '_') slug.pop_back();
  return slug;
}

// "maps/map.png" of a run becomes "maps/map_level_2_raw.png".
std::string path_of(const ResultFile& file, const RunRow& row, const Results& results) {
  const fs::path path(file.path);
  std::string name = path.stem().string();
  if (results.levels.size() > 1) name += fmt::format("_level_{}", row.level);
  if (results.variants.size() > 1) {
    name += "_" + slug_of(results.variants[static_cast<std::size_t>(row.variant)]);
  }
  return (path.parent_path() / (name + path.extension().string())).string();
}

// One without content is not there, nor stays one of before.
void write_tables(const fs::path& folder, const std::vector<ResultFile>& tables) {
  for (const ResultFile& table : tables) {
    const std::string path = (folder / table.path).string();
    if (table.content.empty()) {
      fs::remove(path);
    } else {
      write_file(path, table.content);
    }
  }
}

// The folder in which everything is kept until it is complete.
class Workshop {
 public:
  Workshop(const ScenarioPlan& plan, const ScenarioRunOptions& options, const std::string& identity)
      : plan_(plan), folder_(options.folder), inner_(options.folder + "/runs") {
    if (options.restart) fs::remove_all(inner_);
    std::error_code failed;
    fs::create_directories(inner_ / "files", failed);
    if (failed) throw InputError({inner_.string()}, "cannot be made: " + failed.message());
    journal_.emplace((inner_ / "journal").string(), identity, plan.results.metrics.size());
  }

  Journal& journal() { return *journal_; }

  // Files first: a run that is in the journal is there with all it gave.
  void keep(const RunResult& result) {
    for (const ResultFile& file : result.files) {
      const fs::path path = inner_ / "files" / path_of(file, result.row, plan_.results);
      fs::create_directories(path.parent_path());
      write_file(path.string(), file.content);
    }
    journal_->append({result.row, result.cost});
  }

  // Everything to where it belongs; files that are not here any more were moved by a start that was
  // killed. The provenance comes last: it says that the result is finished.
  void finish(const std::vector<ResultFile>& tables, const std::string& provenance) {
    write_tables(folder_, tables);
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
    write_file((folder_ / kProvenance).string(), provenance);
    journal_.reset();
    fs::remove_all(inner_);
  }

 private:
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

void conclude(const ScenarioPlan& plan, Results& results) {
  const auto by_number = [](const auto& a, const auto& b) { return a.run < b.run; };
  std::sort(results.runs.begin(), results.runs.end(), by_number);
  std::sort(results.costs.begin(), results.costs.end(), by_number);
  results.summary = summarise(results);
  results.claims.clear();
  const Results costs = with_costs_as_metrics(results);
  for (const Claim& claim : plan.scenario.claims) {
    const bool of_cost = is_about_cost(claim);
    results.claims.push_back(judge(claim, of_cost ? costs : results));
    results.claims.back().of_cost = of_cost;
  }
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

std::vector<ResultFile> tables_of(const ScenarioPlan& plan, const Results& results) {
  return {{"config.yaml", plan.config_yaml},
          {"runs.csv", runs_csv(results)},
          {"summary.csv", summary_csv(results)},
          {"claims.csv", claims_csv(results)},
          {"cost_claims.csv", cost_claims_csv(results)},
          {"cost.csv", cost_csv(results)}};
}

// Pictures that an older result of the folder has and this one does not plan.
void remove_old_figures(const std::string& folder, const Results& planned) {
  const std::string config = folder + "/config.yaml";
  if (!fs::exists(config)) return;
  std::vector<PlotSpec> old;
  try {
    old = load_planned(config).plots;
  } catch (const InputError&) {
    return;  // of another program: nothing here is known to be ours
  }
  for (const PlotSpec& plot : old) {
    const bool stays = std::any_of(planned.plots.begin(), planned.plots.end(),
                                   [&](const PlotSpec& p) { return p.file == plot.file; });
    if (stays) continue;
    for (const char* kind : {".svg", ".csv"}) fs::remove(folder + "/figures/" + plot.file + kind);
  }
}

// A finished result of these very runs and this program, with the words, plots and claims of now.
ScenarioRun finished_run(const ScenarioPlan& plan, const std::string& folder) {
  ScenarioRun run{.results = plan.results, .complete = true};
  Results found = load_results(folder);
  run.results.runs = std::move(found.runs);
  run.results.costs = std::move(found.costs);
  run.done_before = static_cast<int>(run.results.runs.size());
  conclude(plan, run.results);
  remove_old_figures(folder, plan.results);
  write_tables(folder, tables_of(plan, run.results));
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

  conclude(plan, run.results);
  Provenance provenance = provenance_of(plan, options, run);
  provenance.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  remove_old_figures(options.folder, plan.results);
  workshop.finish(tables_of(plan, run.results), to_json(provenance));
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
