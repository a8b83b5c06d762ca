#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/output_folder.h"
#include "bench/cli/run/run_shards.h"
#include "bench/cli/run/run_told.h"
#include "bench/pages/reports.h"
#include "bench/process/foreign_files.h"
#include "bench/process/thread_limit.h"
#include "bench/results/plan_yaml.h"
#include "bench/results/result_folder.h"
#include "bench/results/result_tables.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/run_scenario.h"
#include "bench/scenario/runner.h"
#include "bench/scenario/staging_folder.h"
#include "bench/shards/merging.h"
#include "bench/shards/shard_folders.h"
#include "bench/sources/files_record.h"
#include "core/file/csv_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

struct RunArguments {
  std::string scenario;
  bool quick = false;
  bool restart = false;
  bool strict = false;
  int threads = 0;  // 0: as many as the machine has processors
  std::optional<std::uint64_t> seed;
  std::optional<int> run;
  std::string shard;
  int slurm = 0;  // tasks to be submitted; 0: none
  bool status = false;
  std::vector<std::string> sbatch;  // its options
  std::vector<std::string> settings;
  std::string folder;
};

std::string folder_of(const RunArguments& arguments, const Scenario& scenario) {
  if (!arguments.folder.empty()) return arguments.folder;
  return "results/" + scenario.id + (scenario.quick ? "_quick" : "");
}

std::vector<std::string> command_of(const RunArguments& a) {
  std::vector<std::string> command{"mapbed", "run", a.scenario};
  if (a.quick) command.push_back("--quick");
  if (a.threads > 0) command.insert(command.end(), {"-j", fmt::to_string(a.threads)});
  if (a.seed) command.insert(command.end(), {"--seed", fmt::to_string(*a.seed)});
  for (const std::string& setting : a.settings) command.insert(command.end(), {"--set", setting});
  return command;
}

// Why runs of an older result do not count any more, or do not come out as a config.yaml that is
// run again says, where files are the reason. Whether a finished result is told of.
bool tell_changed_files(const std::string& folder, const ScenarioPlan& plan) {
  const InputFiles files = input_files(plan);
  const auto tell = [&files](const std::string& config, const char* meaning) {
    const std::string changes = told_changes(config, files);
    if (!changes.empty()) fmt::print(stderr, "remark: {}; {}\n", changes, meaning);
    return !changes.empty();
  };
  const std::string of_folder = folder + "/config.yaml";
  const bool is_told = tell(of_folder, "all runs are done anew");
  tell(folder + "/runs/tables/config.yaml", "unfinished runs are of the old one");
  const std::vector<Shard> shards = shards_in(folder);
  if (!shards.empty()) {
    tell(folder + "/" + staging_of(shards.front()) + "/tables/config.yaml",
         "what the shards have done is of the old one");
  }
  std::error_code none;
  if (!std::filesystem::equivalent(of_folder, plan.scenario.path, none)) {
    tell(plan.scenario.path, "the results may be others");
  }
  return is_told;
}

// A finished result of something else stays until this one takes its place; one of full size is
// worth too much for a quick one to do so.
void tell_replaced_result(const std::string& folder, const ScenarioPlan& plan, bool is_told) {
  if (finished_identity(folder).empty() || is_finished(plan, folder)) return;
  if (plan.scenario.quick && !load_plan(folder + "/config.yaml").quick) {
    throw InputError({folder}, "holds a result of full size, whose place a quick one would take",
                     "name another folder with --out");
  }
  if (is_told) return;
  fmt::print(stderr,
             "remark: {} holds the finished result of another version of the program, of the "
             "scenario or of its settings; the new one takes its place when it is finished\n",
             folder);
}

constexpr const char* kRow = "run.csv";  // marks a folder of one run
constexpr const char* kConfig = "config.yaml";

// Its row, map, path and pictures, and what makes it again; the files of another run that were
// there go. Foreign ones stay.
void write_one_run(const std::string& folder, const std::string& row, const std::string& config,
                   const RunResult& run) {
  std::vector<std::string> coming{kRow, kConfig};
  for (const ResultFile& file : run.files) coming.push_back(file.path);
  const bool is_ours = std::filesystem::exists(std::filesystem::path(folder) / kRow);
  refuse_foreign(folder, coming, is_ours ? coming : std::vector<std::string>{});
  std::vector<ResultFile> files = run.files;
  files.push_back({kConfig, config});
  files.push_back({kRow, row});
  write_files(folder, files);
  for (const ResultFile& file : files) fmt::print("written: {}/{}\n", folder, file.path);
}

// The run of that number alone; in a folder, where one is named, all that there is of it.
int repeat_one_run(const ScenarioPlan& plan, int number, const std::string& folder) {
  if (number < 0 || number >= plan.runs()) {
    throw InputError(
        fmt::format("there is no run {}; this scenario has 0 to {}", number, plan.runs() - 1));
  }
  const std::string missing = plan.planned_of(plan.row(number)).missing();
  if (!missing.empty()) throw InputError(missing + "; set MAPBED_DATA to the folder that holds it");
  std::optional<OutputFolder> made;
  if (!folder.empty()) {
    if (is_result_folder(folder)) {
      throw InputError({folder}, "holds the results of a scenario",
                       "name another folder for a single run");
    }
    made.emplace(folder);
  }
  const RunResult run = while_told(plan.results.id, [&] { return repeat_run(plan, number); });
  Results results = plan.results;
  results.runs.push_back(run.row);
  const std::string row = runs_csv(results);
  fmt::print("{}", row);
  if (!folder.empty()) write_one_run(folder, row, results.config_yaml, run);
  return kDone;
}

// Ways of running that exclude each other.
void check_ways(const RunArguments& a) {
  const int ways =
      int{a.run.has_value()} + int{!a.shard.empty()} + int{a.slurm > 0} + int{a.status};
  if (ways > 1) {
    throw InputError({}, "--run, --shard, --slurm and --status exclude each other", "give one");
  }
  if (a.status && a.restart) {
    throw InputError({}, "--status and --restart exclude each other", "give one");
  }
  if (a.slurm == 0 && !a.sbatch.empty()) {
    throw InputError({}, fmt::format("one argument too many: '{}'", a.sbatch.front()),
                     "see 'mapbed run --help'");
  }
}

// All runs, or what is left of them.
int do_all(const ScenarioPlan& plan, const ScenarioRunOptions& options, bool strict) {
  const ScenarioRun run = while_working(
      plan.scenario.id, plan.runs_to_do().size(),
      [&](const MayGoOn& may_go_on) { return run_all_shards(plan, options, may_go_on); });
  if (run.complete) return tell_finished(run, options.folder, strict);
  return tell_interrupted(run.results.runs.size(), plan.runs_to_do().size());
}

int run(RunArguments a) {
  check_ways(a);
  std::optional<Shard> shard;
  if (!a.shard.empty()) shard = parse_shard(a.shard);
  ScenarioChoice choice{.quick = a.quick, .seed = a.seed};
  for (const std::string& text : a.settings) choice.settings.push_back(parse_setting(text));
  const ScenarioPlan plan =
      while_told("planning", [&] { return make_plan(load_scenario(a.scenario, choice)); });
  if (a.run) return repeat_one_run(plan, *a.run, a.folder);

  if (a.slurm > 0 && a.threads == 0) a.threads = 1;  // a task has no more, unless it asks for them
  const ScenarioRunOptions options{.folder = folder_of(a, plan.scenario),
                                   .threads = a.threads > 0 ? a.threads : processors(),
                                   .restart = a.restart,
                                   .command = command_of(a)};
  const OutputFolder folder(options.folder);
  refuse_foreign_page(options.folder);
  const bool is_told = tell_changed_files(options.folder, plan);
  if (a.status) return do_status(plan, options, a.strict);
  tell_replaced_result(options.folder, plan, is_told);
  if (a.slurm > 0) return do_slurm(plan, options, a.slurm, a.sbatch, a.strict);
  if (shard) return do_shard(plan, options, *shard, a.strict);
  return do_all(plan, options, a.strict);
}

}  // namespace

Command run_command() {
  const auto a = std::make_shared<RunArguments>();
  return {.name = "run",
          .help = "Run a scenario: simulate, estimate, measure, judge",
          .options = {{.name = "SCENARIO",
                       .target = &a->scenario,
                       .help = "a scenario's name, of 'mapbed list scenarios', or its file (YAML)",
                       .is_required = true},
                      {"SBATCH", &a->sbatch, "with --slurm, behind '--': options of sbatch"},
                      {"--quick", &a->quick,
                       "a reduced version, in seconds; gives no verdict on claims"},
                      {.name = "-j,--threads",
                       .target = &a->threads,
                       .help = "runs at a time; all processors if left out",
                       .check = IntRange{1, 1024}},
                      {"--seed", &a->seed, "the first seed; that of the scenario if left out"},
                      {"--set", &a->settings,
                       "path=value, any option, also 'seeds=10' and the values of an axis: "
                       "'people=[0, 5]'; may come again"},
                      {"-o,--out", &a->folder, "folder for the results; results/NAME if left out"},
                      {"--run", &a->run,
                       "repeat the run of this number alone and print its row; with --out its map, "
                       "path and pictures are written there, too"},
                      {"--shard", &a->shard,
                       "do a part of the runs, '3/8' is the third of eight, by programs that may "
                       "be on several machines; the last one merges"},
                      {.name = "--slurm",
                       .target = &a->slurm,
                       .help = "submit so many shards to Slurm, as an array job; options of sbatch "
                               "stand behind '--'. Again, it submits what was killed or failed",
                       .check = IntRange{1, kMostShards}},
                      {"--status", &a->status,
                       "tell how far the shards are, and merge when all are in; exit status 3 as "
                       "long as they are not"},
                      {"--restart", &a->restart, "throw away what an interrupted start has done"},
                      {"--strict", &a->strict, "exit status 2 where a claim does not hold"}},
          .run = [a] { return run(*a); }};
}

}  // namespace mapbed
