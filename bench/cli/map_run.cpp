#include "bench/cli/map_run.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "algorithms/grid/map_file.h"
#include "algorithms/grid/map_image.h"
#include "algorithms/grid/wall_map.h"
#include "algorithms/pose_graph/graph_file.h"
#include "bench/figures/association_figure.h"
#include "bench/figures/revision_figures.h"
#include "bench/plot/map_picture.h"
#include "bench/process/foreign_files.h"
#include "bench/process/process_cost.h"
#include "bench/process/stopwatch.h"
#include "bench/process/version.h"
#include "bench/results/association_file.h"
#include "bench/scenario/publication.h"
#include "core/file/atomic_file.h"
#include "core/file/utf8.h"
#include "core/geometry/tum_file.h"
#include "core/image/png.h"
#include "core/input_error.h"
#include "core/labels/labels_file.h"
#include "core/labels/tracks_file.h"
#include "core/log/dialects/carmen_log.h"

namespace mapbed {
namespace {

constexpr const char* kMark = "summary.json";
constexpr const char* kLabels = "labels.txt.gz";
constexpr const char* kTracks = "tracks.csv";
constexpr const char* kCleaned = "cleaned.log.gz";
constexpr const char* kGraph = "graph.g2o";
constexpr const char* kAssociations = "associations.json";
constexpr const char* kAssociationFigure = "associations.svg";
constexpr const char* kLikelihoodFigure = "likelihood.svg";
constexpr const char* kKept = "program/";  // folder of what a program was to keep

int count_scans(const SensorLog& log) {
  return static_cast<int>(std::count_if(log.begin(), log.end(), [](const Measurement& m) {
    return std::holds_alternative<LaserScan>(m);
  }));
}

// How many of the log's measurements the estimator has taken in.
std::size_t feed(Estimator& estimator, const SensorLog& log, MapCost& cost,
                 const std::function<bool(std::size_t, std::size_t)>& may_go_on) {
  const Stopwatch all;
  std::size_t done = 0;
  while (done < log.size()) {
    const Stopwatch one;
    estimator.add(log[done]);
    cost.longest_scan = std::max(cost.longest_scan, one.seconds());
    if (!may_go_on(++done, log.size())) break;
  }
  cost.estimating = all.seconds();
  return done;
}

std::string cost_csv(const MapCost& cost) {
  return fmt::format(
      "scans,recorded_s,estimating_s,longest_scan_s,mapping_s,peak_memory_bytes,program_s,"
      "program_memory_bytes\n"
      "{},{:.6f},{:.6f},{:.6f},{:.6f},{:.0f},{:.6f},{:.0f}\n",
      cost.scans, cost.seconds_recorded, cost.estimating, cost.longest_scan, cost.mapping,
      peak_memory(), cost.of_program.processor_seconds, cost.of_program.peak_memory);
}

// What the method gives besides the path, by the files' names.
std::vector<std::string> products_of(const MapRun& run) {
  std::vector<std::string> names;
  if (!run.labels.empty()) names = {kLabels, kCleaned};
  if (run.estimate.tracks) names.push_back(kTracks);
  if (run.estimate.graph) names.push_back(kGraph);
  if (run.estimate.associations) {
    names.push_back(kAssociations);
    names.push_back(kAssociationFigure);
    names.push_back(kLikelihoodFigure);
    if (largest_revision(*run.estimate.associations)) {
      for (const char* name : kRevisionMaps) names.emplace_back(name);
    }
  }
  return names;
}

std::string summary_json(const std::string& log_name, const RecordedLog& log, const MapRun& run) {
  const CellBox box = known_box(run.map);
  nlohmann::ordered_json json{
      {"log", escaped_utf8(log_name)},
      {"format", log.format},
      {"method", run.config.chosen.name},
      {"log_sha256", run.log_sha256},
      {"seed", run.config.seed},
      {"complete", run.complete()},
      {"scans_in_log", run.scans_in_log},
      {"scans_used", run.estimate.trajectory.size()},
      {"untrusted_scans", run.estimate.untrusted_scans},
      {"recorded_s", run.cost.seconds_recorded},
      {"path_length_m", path_length(run.estimate.trajectory)},
      {"products", products_of(run)},
      {"resolution_m", run.map.resolution()},
      {"map_width_m", box.empty() ? 0.0 : box.width() * run.map.resolution()},
      {"map_height_m", box.empty() ? 0.0 : box.height() * run.map.resolution()},
      {"lasers", nlohmann::ordered_json::array()},
      {"remarks", nlohmann::ordered_json::array()},
      {"warnings", nlohmann::ordered_json::array()},
      {"mapbed", version().program},
      {"revision", version().revision},
  };
  if (const ProgramMethod* program = run.config.chosen.program()) {
    json["program"] = {{"version", program->version}, {"files", nlohmann::ordered_json::array()}};
    for (const InputFile& file : program->input_files) {
      json["program"]["files"].push_back({{"path", file.path}, {"sha256", file.sha256}});
    }
  }
  for (const RecordedLaser& laser : log.lasers) json["lasers"].push_back(to_string(laser));
  for (const Remark& remark : run.estimate.remarks) json["remarks"].push_back(remark.text);
  for (const LogWarning& warning : log.warnings) json["warnings"].push_back(to_string(warning));
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

// A map too large to be written is refused before the work is done, as far as the first scan tells,
// and before its memory is taken.
void check_size_of_first_scan(const SensorLog& log, const MapOptions& options) {
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    const CellBox box = box_of_beams({*scan}, {{scan->time, {}}}, options);
    return check_image_size(box, options.resolution, "the map of the first scan alone");
  }
}

struct Maps {
  OccupancyMap map, walls;
};

Maps maps_of(const SensorLog& log, const Estimate& estimate, const MapConfig& config) {
  const Trajectory& trajectory = estimate.trajectory;
  const std::span<const ScanLabels> labels = labels_in(estimate);
  check_image_size(box_of_beams(log, trajectory, config.map), config.map.resolution);
  OccupancyMap map = build_map(log, trajectory, config.map, labels);
  OccupancyMap walls =
      config.map_file == MapFileKind::walls ? wall_map(log, trajectory, config.map, labels) : map;
  return {std::move(map), std::move(walls)};
}

// What is wrong with a log is told, too, where a program gets it as it is.
void add_remarks_on_log(const PreparedLog& prepared, const std::string& program,
                        Estimate& estimate) {
  if (prepared.remarks.empty()) return;
  std::vector<Remark> remarks = prepared.remarks;
  remarks.push_back({RemarkKind::note, program + " got the log as it was recorded, without what is "
                                                 "mended for methods here"});
  estimate.remarks.insert(estimate.remarks.begin(), remarks.begin(), remarks.end());
}

struct Estimated {
  Estimate estimate;
  std::size_t taken = 0;  // measurements of the log
  std::vector<std::pair<std::string, std::string>> kept = {};
};

Estimated estimated_by_ours(const SensorLog& log, const MapConfig& config, MapCost& cost,
                            const std::function<bool(std::size_t, std::size_t)>& may_go_on) {
  const auto estimator = std::get<ConfiguredMethod>(config.chosen.what)
                             .make({}, Rng(config.seed).stream(config.method));
  const std::size_t taken = feed(*estimator, log, cost, may_go_on);
  estimator->finish();
  return {estimator->estimate(), taken};
}

Estimated estimated_by(const ProgramMethod& program, const SensorLog& as_recorded,
                       const SensorLog& prepared, const MapConfig& config, MapCost& cost,
                       const std::function<bool(std::size_t, std::size_t)>& may_go_on) {
  const std::size_t total = prepared.size();
  const auto goes_on = [&] { return may_go_on(0, total); };
  ProgramRun run = run_program_method(program, as_recorded, prepared, config.seed, goes_on);
  cost.of_program = run.cost;
  cost.estimating = run.cost.wall_seconds;
  return {std::move(run.estimate), total, std::move(run.kept)};
}

nlohmann::json summary_in(const std::string& folder) {
  std::ifstream file(std::filesystem::path(folder) / kMark);
  return nlohmann::json::parse(file, nullptr, false);
}

// Of the map that a folder holds, what not every map has: its summary lists them.
std::vector<std::string> products_in(const std::string& folder) {
  const nlohmann::json json = summary_in(folder);
  if (!json.is_object() || !json.contains("products")) return {};
  std::vector<std::string> found;
  for (const char* name : {kLabels, kTracks, kCleaned, kGraph, kAssociations, kAssociationFigure}) {
    const auto& listed = json["products"];
    if (std::find(listed.begin(), listed.end(), name) != listed.end()) found.push_back(name);
  }
  return found;
}

void write_products(const MapRun& run, const RecordedLog& log, Publication& coming) {
  if (!run.labels.empty()) {
    write_labels(coming.add(kLabels), run.labels);
    RecordedLog cleaned = log;
    cleaned.measurements = run.cleaned;
    write_carmen_log(coming.add(kCleaned), cleaned);
  }
  if (run.estimate.tracks) write_file(coming.add(kTracks), tracks_csv(*run.estimate.tracks));
  if (run.estimate.graph) write_file(coming.add(kGraph), graph_text(*run.estimate.graph));
  if (run.estimate.associations) {
    const AssociationTree& tree = *run.estimate.associations;
    write_file(coming.add(kAssociations), associations_json(tree));
    write_file(coming.add(kAssociationFigure), svg_of(association_plot(tree)));
    write_file(coming.add(kLikelihoodFigure), svg_of(likelihood_plot(tree)));
    for (auto& [name, png] : revision_maps(tree, log.measurements, run.config.map)) {
      write_file(coming.add(name), png);
    }
  }
}

}  // namespace

MapRun make_map(const PreparedLog& prepared, const MapConfig& config,
                const std::function<bool(std::size_t done, std::size_t total)>& may_go_on,
                const SensorLog& as_recorded) {
  const SensorLog& log = prepared.log;
  check_size_of_first_scan(log, config.map);
  MapCost cost;
  const auto* program = config.chosen.program();
  Estimated estimated = program == nullptr
                            ? estimated_by_ours(log, config, cost, may_go_on)
                            : estimated_by(*program, as_recorded, log, config, cost, may_go_on);
  Estimate& estimate = estimated.estimate;
  if (program == nullptr) {
    add_remarks_on_input(prepared, estimate);
  } else {
    add_remarks_on_log(prepared, program->name, estimate);
  }
  const Stopwatch mapping;
  const auto part_of_log = [&] {
    return SensorLog(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(estimated.taken));
  };
  const bool whole = estimated.taken == log.size();
  Maps maps = whole ? maps_of(log, estimate, config) : maps_of(part_of_log(), estimate, config);
  cost.mapping = mapping.seconds();
  cost.scans = static_cast<int>(estimate.trajectory.size());
  if (cost.scans > 0) {
    cost.seconds_recorded = estimate.trajectory.back().time - estimate.trajectory.front().time;
  }
  MapRun run{
      config, std::move(estimate), std::move(maps.map), std::move(maps.walls), count_scans(log),
      cost};
  run.was_interrupted = !whole;
  run.kept = std::move(estimated.kept);
  if (run.estimate.labels) {
    run.dynamic =
        dynamic_points(log, run.estimate.trajectory, *run.estimate.labels, config.map.beams);
    run.labels = labels_of_lasers(*run.estimate.labels, log);
    run.cleaned = without_dynamic_beams(as_recorded, run.labels);
  }
  return run;
}

void write_map_run(const std::string& folder, const std::string& log_name, const RecordedLog& log,
                   const MapRun& run) {
  if (known_box(run.walls).empty()) {
    throw InputError({log_name},
                     "no beam of any scan counts, so there is no map: the laser sees nothing, or "
                     "all beams are longer than the usable range",
                     "raise map.beams.usable_range, or take another log; nothing was written");
  }
  Publication coming(folder, kMark);
  for (const std::string& name : products_in(folder)) coming.remove(name);  // of an older map
  write_trajectory(coming.add("trajectory.tum"), run.estimate.trajectory);
  coming.add("map.pgm");
  const std::string yaml = coming.add("map.yaml");
  const bool graded = run.config.map_file == MapFileKind::graded;
  write_map(yaml.substr(0, yaml.rfind('.')), run.walls,
            graded ? MapServerMode::raw : MapServerMode::trinary);
  write_png(coming.add("map.png"), to_image(run.map, image_box(run.walls)));
  write_png(
      coming.add("picture.png"),
      picture_of(run.map, {{run.config.chosen.name, run.estimate.trajectory}}, {}, run.dynamic));
  write_file(coming.add("config.yaml"), to_yaml(run.config));
  write_file(coming.add("cost.csv"), cost_csv(run.cost));
  write_products(run, log, coming);
  for (const auto& [name, content] : run.kept) write_file(coming.add(kKept + name), content);
  write_file(coming.add(kMark), summary_json(log_name, log, run));
  coming.commit();
}

void refuse_foreign_map_files(const std::string& folder, const MapConfig& config) {
  std::vector<std::string> coming{"trajectory.tum", "map.pgm",     "map.yaml", "map.png",
                                  "picture.png",    "config.yaml", "cost.csv", kMark};
  if (config.chosen.labels_beams) {
    for (const char* name : {kLabels, kTracks, kCleaned}) coming.push_back(name);
  }
  if (config.chosen.has_graph) {
    for (const char* name : {kGraph, kAssociations, kAssociationFigure}) coming.push_back(name);
  }
  if (const ProgramMethod* program = config.chosen.program()) {
    for (const std::string& name : program->keep) coming.push_back(kKept + name);
  }
  refuse_foreign(folder, coming, log_of_map(folder).empty() ? std::vector<std::string>{} : coming);
}

std::string log_of_map(const std::string& folder) {
  const nlohmann::json json = summary_in(folder);
  const bool has_log = json.is_object() && json.contains("mapbed") && json.contains("log") &&
                       json["log"].is_string();
  return has_log ? json["log"].get<std::string>() : "";
}

}  // namespace mapbed
