#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "algorithms/input/geometry_check.h"
#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/interrupt.h"
#include "bench/cli/map_run.h"
#include "bench/cli/output_folder.h"
#include "bench/cli/progress.h"
#include "bench/cli/told_log.h"
#include "bench/process/folder_lock.h"
#include "bench/process/foreign_files.h"
#include "bench/process/process_cost.h"
#include "bench/process/stopwatch.h"
#include "bench/process/thread_limit.h"
#include "bench/scenario/publication.h"
#include "bench/sources/chosen_log.h"
#include "core/file/atomic_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMessages = "program_messages.txt";  // of a method that failed

struct MapArguments {
  std::string log;
  std::string method;
  std::string people_filter;
  std::string config_file;
  std::string resolution;
  std::string seed;
  std::string folder;
  int threads = 0;  // 0: as many as the machine has processors
  std::vector<std::string> settings;
};

// The file under --config, then --set in its order, then the options that have a name of their own.
Settings settings_from(const MapArguments& arguments) {
  Settings settings;
  if (!arguments.config_file.empty()) settings = load_settings(arguments.config_file);
  for (const std::string& text : arguments.settings) settings.push_back(parse_setting(text));
  const auto add = [&](const char* path, const char* option, const std::string& text) {
    if (!text.empty()) settings.push_back({path, text, {option + (" " + text), 0}});
  };
  add("method", "--method", arguments.method);
  add("people_filter", "--people-filter", arguments.people_filter);
  add("map.resolution", "--resolution", arguments.resolution);
  add("seed", "--seed", arguments.seed);
  return settings;
}

// The one asked for, or else one that is called as the log; then it may hold no other log's map.
std::string folder_for(const MapArguments& arguments) {
  if (!arguments.folder.empty()) return arguments.folder;
  const std::string folder = name_of_log(arguments.log) + "_map";
  const std::string other = log_of_map(folder);
  std::error_code error;
  if (other.empty() || other == arguments.log || fs::equivalent(other, arguments.log, error)) {
    return folder;
  }
  refuse_of_another_log(folder, "the map", other, "", "name a folder with --out");
}

void check_folder(const std::string& folder, const MapConfig& config) {
  const OutputFolder probe(folder);
  const FolderLock lock(folder);
  finish_publication(folder);  // of a program that was killed
  refuse_foreign_map_files(folder, config);
}

void print_result(const MapRun& run, const std::string& folder, double total) {
  for (const Remark& remark : run.estimate.remarks) {
    fmt::print(stderr, "remark: {}\n", remark.text);
  }
  const CellBox box = known_box(run.map);
  fmt::print("{}: {} poses, {:.1f} m of path, {} of them by prediction alone\n",
             run.config.chosen.name, run.estimate.trajectory.size(),
             path_length(run.estimate.trajectory), run.estimate.untrusted_scans);
  if (!box.empty()) {
    fmt::print("map: {:.1f} x {:.1f} m at {:g} m per cell\n", box.width() * run.map.resolution(),
               box.height() * run.map.resolution(), run.map.resolution());
  }
  const MapCost& cost = run.cost;
  fmt::print("time: {:.2f} ms per scan ({:.1f} ms the longest), map {:.2f} s, all {:.2f} s",
             1e3 * cost.estimating / std::max(1, cost.scans), 1e3 * cost.longest_scan, cost.mapping,
             total);
  if (total > 0.0) fmt::print(", {:.0f} times real time", cost.seconds_recorded / total);
  fmt::print("; {:.0f} MB\n", peak_memory() / 1e6);
  fmt::print("written to {}\n", folder);
}

void refuse_missing_scans(const std::string& path, const SensorLog& log) {
  if (has_scans(log)) return;
  throw InputError({path}, "holds no laser scan", "maps are made of scans");
}

void refuse_needed_map(const ChosenMethod& method) {
  if (!method.needs_map) return;
  throw InputError({}, "the method " + method.name + " makes no map, it needs one",
                   "use 'mapbed localize LOG --map MAP.yaml', or choose another method");
}

void refuse_missing_odometry(const std::string& path, const SensorLog& log,
                             const ChosenMethod& method) {
  const auto is_odometry = [](const Measurement& m) { return std::holds_alternative<Odometry>(m); };
  if (!method.needs_odometry || std::any_of(log.begin(), log.end(), is_odometry)) return;
  throw InputError({path}, "has no odometry, and " + method.name + " has nothing else to go by",
                   "choose a method that matches scans, with --method");
}

// The last line that says something.
std::string last_words(const std::string& messages) {
  const std::size_t end = messages.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return "nothing";
  const std::size_t begin = messages.find_last_of("\n\r", end);
  return in_quotes(messages.substr(begin + 1, end - begin));
}

// None where a program was interrupted. What one that failed has said is kept in the folder.
std::optional<MapRun> made_map(const PreparedLog& prepared, const SensorLog& as_recorded,
                               const MapConfig& config, const std::string& folder,
                               const InterruptGuard& interrupt) {
  const std::string messages = (fs::path(folder) / kMessages).string();
  std::error_code ignored;
  fs::remove(messages, ignored);  // of an earlier one
  Progress progress(config.chosen.name, prepared.log.size());
  const auto may_go_on = [&](std::size_t done, std::size_t) {
    progress.advance_to(done);
    return !interrupt.was_interrupted();
  };
  try {
    return make_map(prepared, config, may_go_on, as_recorded);
  } catch (const Interrupted&) {
    return std::nullopt;
  } catch (const ProgramFailed& error) {
    write_file(messages, error.messages);
    throw InputError(fmt::format("{}; it said {}, all of it is in {}", error.what(),
                                 last_words(error.messages), messages));
  }
}

int map_log(const MapArguments& arguments) {
  const ThreadLimit threads(arguments.threads);
  const Stopwatch stopwatch;
  const Settings settings = settings_from(arguments);
  // Wrong options are told before a log is looked for.
  refuse_needed_map(map_config_from(settings).chosen);
  const ChosenLog chosen = chosen_log(arguments.log);
  const MapConfig config = map_config_from(settings, {.log = chosen.options});
  const std::string folder = folder_for(arguments);
  check_folder(folder, config);  // refused before the log is read
  RecordedLog log = while_told("reading", [&] { return load_log(chosen.path, config.log); });
  const std::vector<Remark> of_geometry = choose_geometry(log);
  print_log(arguments.log, log, stopwatch.seconds());
  refuse_missing_scans(arguments.log, log.measurements);
  refuse_missing_odometry(arguments.log, log.measurements, config.chosen);
  const bool by_program = config.chosen.program() != nullptr;
  const bool is_kept = by_program || config.chosen.labels_beams;
  const SensorLog as_recorded = is_kept ? log.measurements : SensorLog{};
  PreparedLog prepared = mapbed::prepared(std::move(log.measurements), config.input);
  prepared.remarks.insert(prepared.remarks.begin(), of_geometry.begin(), of_geometry.end());
  const OutputFolder made(folder);
  const FolderLock lock(folder);

  const InterruptGuard interrupt;  // not before: there is nothing to keep while a log is read
  std::optional<MapRun> found = made_map(prepared, as_recorded, config, folder, interrupt);
  if (!found || found->estimate.trajectory.empty()) {
    fmt::print(stderr, "mapbed: interrupted before the first scan; nothing was written\n");
    return kInterrupted;
  }
  MapRun& run = *found;
  run.log_sha256 = chosen.sha256;
  while_told("writing", [&] { write_map_run(folder, arguments.log, log, run); });
  print_result(run, folder, stopwatch.seconds());
  if (run.complete()) return kDone;
  fmt::print(stderr, "mapbed: interrupted after {} of {} scans; {} holds the map of these\n",
             run.estimate.trajectory.size(), run.scans_in_log, folder);
  return kInterrupted;
}

}  // namespace

Command map_command() {
  const auto arguments = std::make_shared<MapArguments>();
  return {
      .name = "map",
      .help = "Make a map and a trajectory of a log",
      .options =
          {{.name = "LOG",
            .target = &arguments->log,
            .help = "CARMEN (.log, .clf), CoreSLAM, DP-SLAM or a list of scans, also gzipped; a "
                    "bag of ROS 1 or 2, or MCAP; or the name or .yaml of one that 'mapbed list "
                    "logs' shows",
            .is_required = true},
           {"--method", &arguments->method,
            "who finds the trajectory: a name that 'mapbed list methods' shows, or the file (YAML) "
            "of a program of your own; scan_matching where left out"},
           {"--people-filter", &arguments->people_filter,
            "what tells people and other things that move from the place: a name that 'mapbed list "
            "filters' shows; none where left out"},
           {"--resolution", &arguments->resolution, "side of a cell, as in '5 cm'"},
           {"--seed", &arguments->seed, "of all chance; 1 where left out"},
           {"--set", &arguments->settings,
            "path=value, any option that 'mapbed describe' shows: log.max_range='50 m', "
            "map.model=odds; may come again"},
           {"--config", &arguments->config_file,
            "YAML with such options, as config.yaml in a result's folder"},
           {.name = "-j,--threads",
            .target = &arguments->threads,
            .help = "for methods that share their work out; all processors if left out",
            .check = IntRange{1, 1024}},
           {"-o,--out", &arguments->folder,
            "folder for the results; LOG's name and '_map' here where left out"}},
      .run = [arguments] { return map_log(*arguments); }};
}

}  // namespace mapbed
