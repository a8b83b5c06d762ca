#include "bench/cli/render/map_folder.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "algorithms/input/geometry_check.h"
#include "bench/cli/map_config.h"
#include "bench/cli/map_run.h"
#include "bench/sources/chosen_log.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/labels/labels_file.h"
#include "core/labels/tracks_file.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

// As the files of a map have stamps.
double to_microsecond(double time) {
  return std::round(time * 1e6) / 1e6;
}

// Where the beams ended that the folder's labels call dynamic: ranges stand in the log alone.
DrawnPoints dynamic_points(const fs::path& folder, const std::string& log_name) {
  DrawnPoints drawn{.name = "met what moves"};
  const MapConfig config = map_config_from(load_settings((folder / "config.yaml").string()));
  RecordedLog log = load_log(chosen_log(log_name).path, config.log);
  choose_geometry(log);
  const Trajectory path = load_trajectory((folder / "trajectory.tum").string());
  const BeamLabels all = load_labels((folder / "labels.txt.gz").string());
  std::map<std::pair<double, int>, const ScanLabels*> by_scan;
  for (const ScanLabels& labels : all) {
    by_scan[{to_microsecond(labels.time), labels.laser}] = &labels;
  }
  for (const Measurement& measurement : log.measurements) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    const double time = to_microsecond(scan->time);
    const auto labels = by_scan.find({time, scan->laser});
    const std::optional<Pose2> pose = pose_at(path, time);
    if (labels == by_scan.end() || !pose) continue;
    if (labels->second->static_probability.size() != scan->ranges.size()) continue;
    for_each_beam(*scan, *pose, config.map.beams, [&](std::size_t n, const Beam& beam) {
      if (beam.hit && is_dynamic(*labels->second, n)) drawn.points.push_back(beam.end);
    });
  }
  return drawn;
}

bool is_there(const std::string& log_name) {
  try {
    return fs::exists(chosen_log(log_name).path);
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

WhatMoved what_moved(const std::string& map_yaml) {
  const fs::path folder = fs::path(map_yaml).parent_path();
  WhatMoved moved;
  const std::string log_name =
      fs::path(map_yaml).filename() == "map.yaml" ? log_of_map(folder.string()) : "";
  if (log_name.empty()) return moved;
  const std::string tracks = (folder / "tracks.csv").string();
  if (fs::exists(tracks)) moved.tracks = parse_tracks(tracks, read_text_file(tracks));
  if (fs::exists(folder / "labels.txt.gz") && is_there(log_name)) {
    moved.dynamic = dynamic_points(folder, log_name);
  }
  return moved;
}

}  // namespace mapbed
