#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/progress.h"
#include "bench/process/foreign_files.h"
#include "bench/process/stopwatch.h"
#include "bench/scenario/scenario_log.h"
#include "bench/sources/files_record.h"
#include "bench/sources/log_source.h"
#include "bench/sources/simulated_log.h"
#include "bench/sources/simulation_files.h"
#include "core/data_path.h"
#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

struct SimulateArguments {
  std::string scenario;
  std::string world;
  std::string robot;
  std::string path;
  std::string driver;
  std::string variant;
  std::string log;
  std::string format;
  std::optional<int> people;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> settings;
};

// The options beside a scenario are settings that win over it.
ScenarioChoice choice_of(const SimulateArguments& a) {
  ScenarioChoice choice{.seed = a.seed};
  const auto set = [&](const char* path, const std::string& text) {
    if (text.empty()) return;
    const SourceLocation place{std::string("--") + path, 0};
    choice.settings.push_back({path, with_whole_path(text, place), place});
  };
  set("world", a.world);
  set("robot", a.robot);
  set("path", a.path);
  set("driver", a.driver);
  if (a.people) set("people", fmt::to_string(*a.people));
  for (const std::string& text : a.settings) choice.settings.push_back(parse_setting(text));
  return choice;
}

struct SimulationToRun {
  PreparedSimulation simulation;
  std::uint64_t seed;
};

SimulationToRun simulation_of(const SimulateArguments& a) {
  const ScenarioChoice choice = choice_of(a);
  if (!a.scenario.empty()) {
    const Scenario scenario = load_scenario(a.scenario, choice);
    SimulationToRun to_run{simulation_in(scenario, a.variant), scenario.seed};
    const std::string changes = told_changes(scenario.path, to_run.simulation.files);
    if (!changes.empty()) fmt::print(stderr, "remark: {}; the log may be another one\n", changes);
    return to_run;
  }
  if (a.world.empty() || a.robot.empty()) {
    throw InputError("simulate needs a scenario file, or --world and --robot");
  }
  return {prepare_simulation(simulation_plan(choice.settings)), a.seed.value_or(1)};
}

// As named, or else by the ending of the log.
const LogFormat& format_of(const SimulateArguments& a) {
  return a.format.empty() ? log_format_of_path(a.log) : log_format_by_name(a.format);
}

// Nothing is written over but what a simulation has written.
void check_output(const std::string& log, const LogFormat& format) {
  // Of a folder that is not there yet: whether something of that name can be made.
  if (!format.is_folder || !std::filesystem::is_directory(log)) check_writable(log);
  refuse_foreign_simulation_files(log, format);
  const bool is_there = std::filesystem::is_regular_file(log);
  if (is_there && !is_special_file(log) && !is_simulated_log(log)) refuse_foreign(log);
}

// Before anything is recorded.
void refuse_unwritable_rfid(const std::string& log, const LogFormat& format, const Robot& robot) {
  if (format.has_rfid || antennas_of(robot).empty()) return;
  throw InputError({log},
                   fmt::format("the robot {} has RFID antennas, and the format {} cannot say what "
                               "they hear",
                               robot.name, format.name),
                   "write a CARMEN log, as x.log");
}

// [m] of the path that is driven: how long the work will be.
std::size_t path_meters(const NamedPath& path) {
  double meters = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    meters += (path.points[i].position - path.points[i - 1].position).norm();
  }
  return static_cast<std::size_t>(std::ceil(meters));
}

SimulationResult told_simulation(const SimulationToRun& to_run) {
  Progress progress("simulating, m of path", path_meters(to_run.simulation.path));
  return run_watched_simulation(to_run.simulation, to_run.seed, [&](double meters) {
    progress.advance_to(static_cast<std::size_t>(meters));
  });
}

int simulate(SimulateArguments arguments) {
  const LogFormat& format = format_of(arguments);
  std::string& log = arguments.log;
  while (format.is_folder && log.size() > 1 && log.ends_with('/')) log.pop_back();
  check_output(arguments.log, format);
  const SimulationToRun to_run =
      while_told("building the world", [&] { return simulation_of(arguments); });
  refuse_unwritable_rfid(log, format, to_run.simulation.robot);
  refuse_files_of_another_log(log, format, to_run.simulation, to_run.seed);
  const Stopwatch stopwatch;
  const SimulationResult result = told_simulation(to_run);
  const double seconds = stopwatch.seconds();
  while_told("writing", [&] { write_simulation(arguments.log, result, format); });

  const auto& scans = result.recording.truth.beams;
  const Trajectory truth = trajectory_of(result.recording.truth);
  const double recorded = scans.empty() ? 0.0 : scans.back().time - scans.front().time;
  // Where the log goes to a pipe or to standard output, these words do not.
  const bool is_alone = !format.is_folder && is_special_file(arguments.log);
  std::FILE* const words = is_alone ? stderr : stdout;
  fmt::print(words,
             "{} in {}: {} scans, {:.1f} s, {:.1f} m of path; simulated in {:.2f} s, {:.0f} times "
             "real time\n",
             result.simulation.robot.name, result.simulation.world->name, scans.size(), recorded,
             path_length(truth), seconds, seconds > 0.0 ? recorded / seconds : 0.0);
  const RecordingEnd& end = result.recording.end;
  if (!end.stuck.empty()) {
    fmt::print(stderr, "remark: {}; the recording ends there\n", end.stuck);
  } else if (!end.is_complete) {
    fmt::print(stderr, "remark: the robot did not get to the end of its path in time\n");
  }
  fmt::print(words, "written to {}{}\n", arguments.log, is_alone ? "" : " and files beside it");
  return kDone;
}

}  // namespace

Command simulate_command() {
  const auto a = std::make_shared<SimulateArguments>();
  return {.name = "simulate",
          .help = "Record a log in a simulated world, with truth, relations and true map beside it",
          .options = {{"SCENARIO", &a->scenario, "a scenario's name or file (YAML)"},
                      {"--world", &a->world, "a world's name or file"},
                      {"--robot", &a->robot, "a robot's name or file"},
                      {"--path", &a->path,
                       "a named path of the world, as 'mapbed describe WORLD' lists them; its "
                       "first where left out"},
                      {"--driver", &a->driver,
                       "who drives, of 'mapbed list drivers'; the usual one of the robot's drive "
                       "where left out"},
                      {.name = "--people",
                       .target = &a->people,
                       .help = "how many are about, all together; as the world says if left out",
                       .check = Sign::not_negative},
                      {"--seed", &a->seed,
                       "of everything that is chance; the scenario's, or 1, if left out"},
                      {"--variant", &a->variant, "which of those that the scenario compares"},
                      {"--set", &a->settings,
                       "path=value, any option: world.…, robot.…, simulation.…, driver.…, "
                       "recorder.…, faults.…; of a scenario that sweeps one, its value; may come "
                       "again"},
                      {.name = "--format",
                       .target = &a->format,
                       .help = "of the log: ros1, ros2 (a folder), mcap, … as 'mapbed list "
                               "formats' shows; by its ending where left out, as .bag, .mcap"},
                      {.name = "-o,--out",
                       .target = &a->log,
                       .help = "the log to write; .gz: a compressed CARMEN log",
                       .is_required = true}},
          .run = [a] { return simulate(*a); }};
}

}  // namespace mapbed
