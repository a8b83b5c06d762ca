#include "bench/sources/simulation_files.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/process/foreign_files.h"
#include "bench/sources/files_record.h"
#include "core/config/config_node.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/geometry/tum_file.h"
#include "core/image/map_server.h"
#include "core/input_error.h"
#include "core/log/bags/bag_writer.h"
#include "core/log/log_file.h"
#include "sim/relations.h"
#include "sim/truth/truth_file.h"
#include "worlds/geometry/raster.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// "dir/name.log.gz" -> "dir/name"
std::string stem_of(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();  // of a bag of ROS 2
  for (const char* ending : {".gz", ".log", ".clf", ".rawlog", ".bag", ".mcap"}) {
    if (path.ends_with(ending)) path.resize(path.size() - std::string(ending).size());
  }
  return path;
}

void write_true_map(const std::string& stem, const PreparedSimulation& simulation) {
  RasterOptions options;
  options.height = lasers_of(simulation.robot).front().robot_from_laser.z;
  const TrueMap map = raster(*simulation.world, options);
  MapServerMap file{
      .occupancy = Image<float>(map.width, map.height, MapServerMap::kUnknown),
      .resolution = map.resolution,
      .map_from_image = {map.origin.x(), map.origin.y(), 0.0},
  };
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const TrueCell cell = map.at(x, y);
      if (cell == TrueCell::free) file.occupancy.at(x, map.height - 1 - y) = 0.0F;
      if (cell == TrueCell::occupied) file.occupancy.at(x, map.height - 1 - y) = 1.0F;
    }
  }
  write_map_server(stem + "_map", file);
}

// A drive too short for a relation has no such file, nor an older one of its name.
void write_relations(const std::string& path, const Trajectory& truth) {
  const std::string text = relations_text(truth);
  if (text.empty()) {
    fs::remove(path);
  } else {
    write_text_file(path, text);
  }
}

constexpr const char* kConfig = ".config.yaml";
constexpr const char* kBeside[] = {kConfig, ".truth.gz", ".relations",
                                   ".tum",  "_map.pgm",  "_map.yaml"};

std::string config_of(const PreparedSimulation& simulation, std::uint64_t seed) {
  return fmt::format("seed: {}\n", seed) + simulation.config + simulation.faults.complete_yaml +
         files_yaml(simulation.files);
}

// The configuration first: it says whose the others are, also after a kill.
void write_beside(const std::string& stem, const SimulationResult& result,
                  const Trajectory& truth) {
  write_text_file(stem + kConfig, config_of(result.simulation, result.seed));
  write_truth(stem + ".truth.gz", result.recording.truth);
  write_relations(stem + ".relations", truth);
  write_trajectory(stem + ".tum", truth);
  write_true_map(stem, result.simulation);
}

// Whether that configuration is one that write_beside has written.
bool is_of_simulation(const std::string& path) {
  if (!fs::exists(path)) return false;
  try {
    const ConfigNode config = load_config(path);
    for (const char* key : {"seed", "world", "robot", "path", "driver", "files"}) {
      if (config.find(key) == nullptr) return false;
    }
    return true;
  } catch (const InputError&) {
    return false;
  }
}

// The log itself, or what is written into its folder.
std::vector<std::string> files_of(const std::string& log_path, const LogFormat& format) {
  if (!format.is_folder) return {log_path};
  const auto files = files_of_rosbag2(log_path);
  return {files.begin(), files.end()};
}

// What else is in the folder of a bag would be taken for a part of it.
void refuse_foreign_folder(const std::string& folder, bool is_ours) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) {
    throw InputError({folder}, "is a file, and bags of ROS 2 are folders", "name a folder");
  }
  const auto files = files_of_rosbag2(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    const bool is_coming =
        std::find(files.begin(), files.end(), entry.path().string()) != files.end();
    if (!is_ours || !is_coming) refuse_foreign(entry.path().string());
  }
}

// Logs of that name with another ending, sorted: what stands beside belongs to them, too.
std::vector<std::string> other_logs(const std::string& log_path) {
  const std::string stem = stem_of(log_path);
  const fs::path folder = fs::path(stem).parent_path();
  std::vector<std::string> others;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, none)) {
    const std::string path = (folder / entry.path().filename()).string();
    if (stem_of(path) != (folder / fs::path(stem).filename()).string()) continue;
    if (entry.is_directory(none) && !fs::exists(files_of_rosbag2(path).back())) continue;
    if (!fs::equivalent(path, log_path, none)) others.push_back(path);
  }
  std::sort(others.begin(), others.end());
  return others;
}

// "'seed: 1', here 'seed: 2'": the first line in which they differ, without its comment.
std::string told_difference(std::string_view there, std::string_view here) {
  while (!there.empty() || !here.empty()) {
    const std::string_view a = next_line(there);
    const std::string_view b = next_line(here);
    if (a == b) continue;
    return fmt::format("{}, here {}", in_quotes(a.substr(0, a.find("  #"))),
                       in_quotes(b.substr(0, b.find("  #"))));
  }
  return "";
}

}  // namespace

bool is_simulated_log(const std::string& log_path) {
  return is_of_simulation(stem_of(log_path) + kConfig);
}

void write_simulation(const std::string& log_path, const SimulationResult& result,
                      const LogFormat& format) {
  const Trajectory truth = trajectory_of(result.recording.truth);
  if (format.is_folder || !is_special_file(log_path)) {  // else nothing stands beside it
    // Behind a link, which stays.
    for (const std::string& file : files_of(log_path, format)) {
      if (fs::exists(file)) {
        fs::remove(fs::canonical(file));
      }
    }
    write_beside(stem_of(log_path), result, truth);
  }
  RecordedLog log;
  log.format = "CARMEN";
  log.measurements = result.log;
  log.true_poses = truth;
  format.write(log_path, log);
}

void refuse_foreign_simulation_files(const std::string& log_path, const LogFormat& format) {
  if (!format.is_folder && is_special_file(log_path)) return;
  const fs::path stem = stem_of(log_path);
  const bool is_ours = is_of_simulation(stem.string() + kConfig);
  if (format.is_folder) refuse_foreign_folder(log_path, is_ours);
  std::vector<std::string> coming;
  for (const char* ending : kBeside) coming.push_back(stem.filename().string() + ending);
  refuse_foreign(stem.parent_path().string(), coming,
                 is_ours ? coming : std::vector<std::string>{});
}

void refuse_files_of_another_log(const std::string& log_path, const LogFormat& format,
                                 const PreparedSimulation& simulation, std::uint64_t seed) {
  if (!format.is_folder && is_special_file(log_path)) return;
  const std::string stem = stem_of(log_path);
  if (!fs::exists(stem + kConfig)) return;
  const std::string difference =
      told_difference(read_text_file(stem + kConfig), config_of(simulation, seed));
  const std::vector<std::string> logs = other_logs(log_path);
  if (difference.empty() || logs.empty()) return;
  std::vector<std::string> replaced;
  for (const char* ending : kBeside) {
    if (fs::exists(stem + ending)) replaced.push_back(fs::path(stem + ending).filename());
  }
  refuse_of_another_log(
      stem + kConfig, "the drive", fmt::format("{}", fmt::join(logs, ", ")),
      fmt::format(" ({}); {} would be written over", difference, fmt::join(replaced, ", ")),
      "name another log with --out");
}

}  // namespace mapbed
