#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "algorithms/grid/map_file.h"
#include "algorithms/input/geometry_check.h"
#include "algorithms/localization/free_space.h"
#include "bench/cli/command_line.h"
#include "bench/cli/commands.h"
#include "bench/cli/interrupt.h"
#include "bench/cli/localize_run.h"
#include "bench/cli/output_folder.h"
#include "bench/cli/progress.h"
#include "bench/cli/told_log.h"
#include "bench/cli/told_tags.h"
#include "bench/process/folder_lock.h"
#include "bench/process/foreign_files.h"
#include "bench/process/process_cost.h"
#include "bench/process/stopwatch.h"
#include "bench/process/thread_limit.h"
#include "bench/scenario/publication.h"
#include "bench/sources/chosen_log.h"
#include "core/config/quantity.h"
#include "core/geometry/angle.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

struct LocalizeArguments {
  std::string log;
  std::string map;
  std::string tags;
  std::string start;
  std::string people_filter;
  std::string config_file;
  std::string seed;
  std::string folder;
  int threads = 0;  // 0: as many as the machine has processors
  std::vector<std::string> settings;
};

Settings settings_from(const LocalizeArguments& arguments) {
  Settings settings;
  if (!arguments.config_file.empty()) settings = load_settings(arguments.config_file);
  for (const std::string& text : arguments.settings) settings.push_back(parse_setting(text));
  const auto add = [&](const char* path, const char* option, const std::string& text) {
    if (!text.empty()) settings.push_back({path, text, {option + (" " + text), 0}});
  };
  settings.push_back({"method", "localization", {}});
  // Tags of a place of one's own answer otherwise than those that a model was learned of, and their
  // silence would be taken for distance.
  const std::string silence = "localization.rfid.non_detections";
  const bool is_told = std::any_of(settings.begin(), settings.end(),
                                   [&](const Setting& setting) { return setting.path == silence; });
  if (!is_told) settings.push_back({silence, "false", {}});
  add("people_filter", "--people-filter", arguments.people_filter);
  add("seed", "--seed", arguments.seed);
  return settings;
}

// "2 m, 1.5 m, 90 deg"
std::optional<Pose2> start_from(const std::string& text) {
  if (text.empty()) return {};
  const SourceLocation place{"--start " + text, 0};
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back().push_back(c);
    }
  }
  if (parts.size() != 3) {
    throw InputError(place, "is not x, y and heading", "write --start '2 m, 1.5 m, 90 deg'");
  }
  return Pose2{parse_quantity(parts[0], Unit::meter, place),
               parse_quantity(parts[1], Unit::meter, place),
               normalized_angle(parse_quantity(parts[2], Unit::radian, place))};
}

void check_start(const Pose2& start, const OccupancyMap& map, const std::string& map_path) {
  const std::optional<std::string> trouble = trouble_at(map, start.position());
  if (!trouble) return;
  const CellBox box = known_box(map);
  const Eigen::Vector2d low = map.frame().corner_of(box.min);
  const Eigen::Vector2d high = map.frame().corner_of({box.max.x + 1, box.max.y + 1});
  throw InputError({map_path},
                   fmt::format("the start ({:g} m, {:g} m) is {}, which reaches from ({:g} m, {:g} "
                               "m) to ({:g} m, {:g} m)",
                               start.x, start.y, *trouble, low.x(), low.y(), high.x(), high.y()),
                   "name a free place with --start, or leave it out");
}

// Throws InputError where there is nowhere to be.
std::shared_ptr<const OccupancyMap> map_from(const std::string& path) {
  auto map = std::make_shared<OccupancyMap>(read_map(path));
  const FreeSpace space(map);
  if (space.empty()) {
    throw InputError({path}, "nothing of the map is free, so that no robot can be there",
                     "look at 'negate' and the thresholds of its .yaml");
  }
  const bool has_walls = !map->box_where(is_occupied).empty();
  if (!has_walls) {
    throw InputError({path}, "nothing of the map is occupied, so that no scan can be told apart",
                     "look at 'negate' and the thresholds of its .yaml");
  }
  const CellBox box = known_box(*map);
  fmt::print("{}: {:.1f} x {:.1f} m at {:g} m per cell, {:.0f} m² of it free\n", path,
             box.width() * map->resolution(), box.height() * map->resolution(), map->resolution(),
             space.area());
  return map;
}

std::string folder_for(const LocalizeArguments& arguments) {
  if (!arguments.folder.empty()) return arguments.folder;
  const std::string folder = name_of_log(arguments.log) + "_localized";
  const std::string other = log_of_localization(folder);
  std::error_code error;
  if (other.empty() || other == arguments.log || fs::equivalent(other, arguments.log, error)) {
    return folder;
  }
  refuse_of_another_log(folder, "the path", other, "", "name a folder with --out");
}

void check_folder(const std::string& folder) {
  const OutputFolder probe(folder);
  const FolderLock lock(folder);
  finish_publication(folder);
  refuse_foreign_localize_files(folder);
}

// Of the whole log, or of what came before an interruption.
void localize(const PreparedLog& prepared, const std::optional<Pose2>& start,
              const std::vector<TagBelief>& tags, LocalizeRun& run) {
  const Given given{.start = start, .map = run.map, .tags = tags};
  const auto estimator = std::get<ConfiguredMethod>(run.config.chosen.what)
                             .make(given, Rng(run.config.seed).stream(run.config.method));
  const InterruptGuard interrupt;
  Progress progress(run.config.chosen.name, prepared.log.size());
  std::size_t done = 0;
  while (done < prepared.log.size() && !interrupt.was_interrupted()) {
    estimator->add(prepared.log[done]);
    progress.advance_to(++done);
  }
  run.complete = done == prepared.log.size();
  estimator->finish();
  run.estimate = estimator->estimate();
  add_remarks_on_input(prepared, run.estimate);
}

void print_result(const LocalizeRun& run, const std::string& folder, double total) {
  for (const Remark& remark : run.estimate.remarks) {
    fmt::print(stderr, "remark: {}\n", remark.text);
  }
  const KnownSummary known = known_summary(run.estimate);
  if (known.known_from < 0.0) {
    fmt::print("{} poses; where the robot is was never known\n", known.scans);
  } else {
    fmt::print(
        "{} poses, {:.1f} m of path; known from {:.1f} s on, lost {} times after that, {:.1f} "
        "% of the scans known\n",
        known.scans, path_length(run.estimate.trajectory), known.known_from, known.times_lost,
        100.0 * known.known_scans / known.scans);
  }
  fmt::print("time: {:.2f} s; {:.0f} MB\n", total, peak_memory() / 1e6);
  fmt::print("written to {}\n", folder);
}

int localize_log(const LocalizeArguments& arguments) {
  const ThreadLimit threads(arguments.threads);
  const Stopwatch stopwatch;
  const Settings settings = settings_from(arguments);
  map_config_from(settings);  // wrong options are told before a file is looked for
  const std::optional<Pose2> start = start_from(arguments.start);
  const ChosenLog chosen = chosen_log(arguments.log);
  LocalizeRun run{.config = map_config_from(settings, {.log = chosen.options}),
                  .map_path = arguments.map,
                  .map = map_from(arguments.map),
                  .tags_path = arguments.tags,
                  .estimate = {}};
  if (start) check_start(*start, *run.map, arguments.map);
  std::vector<TagBelief> tags;
  if (!arguments.tags.empty()) tags = tags_on_map(arguments.tags, *run.map);
  const std::string folder = folder_for(arguments);
  check_folder(folder);  // refused before the log is read
  RecordedLog log = while_told("reading", [&] { return load_log(chosen.path, run.config.log); });
  const std::vector<Remark> of_geometry = choose_geometry(log);
  print_log(arguments.log, log, stopwatch.seconds());
  if (tags.empty() && !has_scans(log.measurements)) {
    throw InputError({arguments.log}, "holds no laser scan",
                     "say where its RFID tags are by --tags, or take another log");
  }
  if (!tags.empty()) check_has_rounds(arguments.log, log.measurements);
  const std::vector<Remark> of_tags = tags.empty()
                                          ? std::vector<Remark>{}
                                          : remarks_on_tags(arguments.tags, tags, log.measurements);
  PreparedLog prepared = mapbed::prepared(std::move(log.measurements), run.config.input);
  prepared.remarks.insert(prepared.remarks.begin(), of_geometry.begin(), of_geometry.end());
  const OutputFolder made(folder);
  const FolderLock lock(folder);
  prepared.remarks.insert(prepared.remarks.end(), of_tags.begin(), of_tags.end());
  localize(prepared, start, tags, run);
  if (run.estimate.trajectory.empty()) {
    fmt::print(stderr, "mapbed: interrupted before the first pose; nothing was written\n");
    return kInterrupted;
  }
  write_localize_run(folder, arguments.log, run);
  print_result(run, folder, stopwatch.seconds());
  return run.complete ? kDone : kInterrupted;
}

}  // namespace

Command localize_command() {
  const auto arguments = std::make_shared<LocalizeArguments>();
  return {
      .name = "localize",
      .help = "Find where a robot was in a map that is given",
      .options =
          {{.name = "LOG",
            .target = &arguments->log,
            .help = "a log, in any form that 'mapbed map' takes",
            .is_required = true},
           {.name = "--map",
            .target = &arguments->map,
            .help = "map of the place in the form of ROS' map_server: its .yaml",
            .is_required = true},
           {"--tags", &arguments->tags,
            "where RFID tags are: a table tag,x,y of known places, or tag,x,y,weight of beliefs, "
            "in "
            "the map's frame; what the log's reader hears of them counts, too"},
           {"--start", &arguments->start,
            "where the robot is at the first scan, as in '2 m, 1.5 m, 90 deg'; anywhere where left "
            "out"},
           {"--people-filter", &arguments->people_filter,
            "what tells people and other things that move from the place: a name that 'mapbed list "
            "filters' shows; none where left out"},
           {"--seed", &arguments->seed, "of all chance; 1 where left out"},
           {"--set", &arguments->settings,
            "path=value, any option that 'mapbed describe localization' shows: "
            "localization.particles.most=100000; may come again"},
           {"--config", &arguments->config_file,
            "YAML with such options, as config.yaml in a result's folder"},
           {.name = "-j,--threads",
            .target = &arguments->threads,
            .help = "all processors if left out",
            .check = IntRange{1, 1024}},
           {"-o,--out", &arguments->folder,
            "folder for the results; LOG's name and '_localized' here where left out"}},
      .run = [arguments] { return localize_log(*arguments); }};
}

}  // namespace mapbed
