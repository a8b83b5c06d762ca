#include "bench/cli/describe/file_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/cli/catalogue.h"
#include "bench/cli/describe/pose_lines.h"
#include "bench/cli/describe/what_moved_text.h"
#include "bench/metrics/relations.h"
#include "bench/results/result_folder.h"
#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/samples.h"
#include "core/input_error.h"
#include "core/labels/labels_file.h"
#include "core/labels/tracks_file.h"
#include "core/log/log_file.h"
#include "sim/truth/truth_file.h"
#include "worlds/file/obj_file.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRead =
    "read are: logs (CARMEN, CoreSLAM, DP-SLAM, scan lists, bags of ROS 1 and 2, MCAP), "
    "trajectories "
    "(lines of 4 or 8 numbers), relations, truth (.truth.gz), maps (.yaml with .pgm or .png), "
    "pictures, meshes (.obj), labels, tracks, tables (.csv), YAML files of scenarios, worlds, "
    "robots, sensors, "
    "methods, logs and maps, and folders of results and maps";

std::string plain_name(const std::string& path) {  // without .gz
  return path.ends_with(".gz") ? path.substr(0, path.size() - 3) : path;
}

FileText text_of_trajectory(const std::string& path, std::string_view content) {
  const Trajectory poses = parse_trajectory(path, content);
  Eigen::AlignedBox2d box;
  for (const auto& [time, pose] : poses) box.extend(Eigen::Vector2d(pose.x, pose.y));
  return {"trajectory",
          fmt::format("poses: {} in {:.1f} s, from {:.6f} to {:.6f} s\npath length: {:.2f} m\n"
                      "bounding box: ({:.2f}, {:.2f}) to ({:.2f}, {:.2f}), {:.2f} m x {:.2f} m\n",
                      poses.size(), poses.back().time - poses.front().time, poses.front().time,
                      poses.back().time, path_length(poses), box.min().x(), box.min().y(),
                      box.max().x(), box.max().y(), box.sizes().x(), box.sizes().y())};
}

FileText text_of_relations(const std::vector<Relation>& relations) {
  double first = relations.front().from_time;
  double last = first;
  double longest = 0.0;
  for (const Relation& relation : relations) {
    first = std::min({first, relation.from_time, relation.to_time});
    last = std::max({last, relation.from_time, relation.to_time});
    longest = std::max(longest, std::hypot(relation.from_to.x, relation.from_to.y));
  }
  return {"relations",
          fmt::format("relations: {} between stamps from {:.6f} to {:.6f} s\nlongest: {:.2f} m\n",
                      relations.size(), first, last, longest)};
}

// Lines of eight numbers are poses, or relations where their last four are no unit quaternions.
FileText text_of_pose_lines(const std::string& path, std::string_view content) {
  try {
    return text_of_trajectory(path, content);
  } catch (const InputError&) {
    try {
      const std::vector<Relation> relations = parse_relations(path, content);
      if (!relations.empty()) return text_of_relations(relations);
    } catch (const InputError&) {
      // Neither: what is wrong with it as a trajectory is told.
    }
    throw;
  }
}

FileText text_of_truth(const std::string& path) {
  TruthHeader found;
  std::size_t states = 0;
  std::size_t scans = 0;
  double first = 0.0;
  double last = 0.0;
  TruthSink sink;
  sink.header = [&](const TruthHeader& header) { found = header; };
  sink.states = [&](StampedStates&& state) {
    if (states++ == 0) first = state.time;
    last = state.time;
  };
  sink.beams = [&](BeamTruthOfScan&&) { ++scans; };
  std::map<ReadMechanism, int> reads;
  sink.reads = [&](TruthRead&& read) { ++reads[read.mechanism]; };
  read_truth(path, sink);
  const auto moving = std::count_if(found.entities.begin(), found.entities.end(),
                                    [](const TruthEntity& entity) { return entity.is_dynamic(); });
  std::string text = fmt::format(
      "world: {}\nrobot: {}\nthings: {}, of them {} that can move\nstates: {} from {:.3f} to "
      "{:.3f} s\nscans: {}\n",
      found.world, found.robot, found.entities.size(), moving, states, first, last, scans);
  if (!found.tags.empty()) {
    text += fmt::format(
        "RFID tags: {}, read {} times directly, {} by a reflection, {} by another antenna; {} "
        "ghosts\n",
        found.tags.size(), reads[ReadMechanism::direct], reads[ReadMechanism::reflection],
        reads[ReadMechanism::wrong_antenna], reads[ReadMechanism::ghost]);
  }
  return {"truth", text};
}

FileText text_of_picture(const std::string& path) {
  const std::string yaml = fs::path(path).replace_extension(".yaml").string();
  if (fs::is_regular_file(yaml)) return text_of_map(yaml);
  const Samples picture = read_samples(path);
  return {"picture", fmt::format("size: {} x {} pixels, {} channels\nremark: as a map it needs {} "
                                 "beside it, or 'mapbed render --resolution'\n",
                                 picture.width, picture.height, picture.channels,
                                 fs::path(yaml).filename().string())};
}

FileText text_of_mesh(const std::string& path) {
  const TriangleMesh mesh = load_obj(path);
  return {"mesh",
          fmt::format("triangles: {}\ncorners: {}\n", mesh.triangles.size(), mesh.vertices.size())};
}

FileText text_of_table(const std::string& path, std::string_view content) {
  const std::vector<CsvRow> rows = parse_csv(path, content);
  std::string text = fmt::format("rows: {}\ncolumns:\n", rows.empty() ? 0 : rows.size() - 1);
  if (!rows.empty()) {
    for (const std::string& name : rows.front()) text += "  - " + name + "\n";
  }
  return {"table", text};
}

// The values of a JSON file, a line each; of lists of objects only how many there are.
std::string lines_of(const nlohmann::ordered_json& json) {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (value.is_string()) {
      text += key + ": " + value.get<std::string>() + "\n";
    } else if (value.is_array() && !value.empty() && value.front().is_string()) {
      text += key + ":\n";
      for (const auto& item : value) text += "  - " + item.get<std::string>() + "\n";
    } else if (value.is_array() && !value.empty() && value.front().is_structured()) {
      text += fmt::format("{}: {}\n", key, value.size());
    } else {
      text += key + ": " + value.dump() + "\n";
    }
  }
  return text;
}

FileText text_of_json(const std::string& path, const std::string& content) {
  const auto json = nlohmann::ordered_json::parse(content, nullptr, false);
  if (!json.is_object()) throw InputError({path}, "is no JSON that mapbed writes", kRead);
  const bool is_map = json.contains("log") && json.contains("method");
  return {is_map ? "map of a log" : "figures", lines_of(json)};
}

FileText text_of_folder(const std::string& path) {
  const std::string summary = (fs::path(path) / "summary.json").string();
  if (fs::is_regular_file(summary)) return text_of_json(summary, read_text_file(summary));
  if (is_result_folder(path)) return text_of_results(path);
  std::string text;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path, ignored)) {
    if (!is_result_folder(entry.path().string())) continue;
    text += "  - " + entry.path().filename().string() + "\n";
  }
  if (text.empty()) {
    throw InputError({path}, "is a folder of neither results, nor a map, nor a bag", kRead);
  }
  return {"folder of results", "results:\n" + text};
}

FileText text_of_other_log(const std::string& path) {
  try {
    return {"log", text_of_log(path)};
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) + "; " + kRead);
  }
}

FileText text_of_bag_with_log(const std::string& path, const BagContents& bag) {
  // Its topics first, so that they are there also where it is not clear which of them are meant.
  FileText found{"log", text_of_bag(bag)};
  try {
    const std::string text = text_of_log(path);
    found.text += text.substr(text.find('\n') + 1);  // the format is told
  } catch (const InputError& error) {
    if (bag.topics.empty()) throw;
    found.text += std::string("remark: ") + error.what() + "\n";
  }
  return found;
}

}  // namespace

FileText text_of_results(const std::string& folder) {
  const Results results = load_results(folder);
  const auto failed = std::count_if(results.runs.begin(), results.runs.end(),
                                    [](const RunRow& run) { return !run.failure.empty(); });
  int held = 0;
  int judged = 0;
  for (const Verdict& verdict : results.verdicts) {
    held += verdict.judged && verdict.held ? 1 : 0;
    judged += verdict.judged ? 1 : 0;
  }
  std::string text = fmt::format(
      "scenario: {}{}\nabout: {}\nruns: {}, {} of them failed; {} levels, {} variants, {} seeds "
      "from {} on\nclaims: {}, {} judged, {} held\n",
      results.id, results.quick ? " (quick)" : "", results.about, results.runs.size(), failed,
      results.levels.size(), results.variants.size(), results.seeds, results.seed,
      results.verdicts.size(), judged, held);
  for (const std::string& line : results.skipped) text += "skipped: " + line + "\n";
  const auto made = nlohmann::json::parse(results.provenance_json, nullptr, false);
  if (made.is_object() && made.contains("program") && made["program"].is_object()) {
    const auto& program = made["program"];
    text += "made by: mapbed " + program.value("version", std::string("?")) + ", revision " +
            program.value("revision", std::string("?")) + "\n";
  }
  return {"results", text};
}

std::optional<FileText> text_of_file(const std::string& path) {
  if (const auto bag = bag_contents(path)) return text_of_bag_with_log(path, *bag);
  if (fs::is_directory(path)) return text_of_folder(path);
  if (!fs::is_regular_file(path)) return {};
  const std::string name = plain_name(path);
  if (name.ends_with(".yaml") || name.ends_with(".yml")) {
    std::optional<FileText> found = text_of_yaml(path);
    if (found) return found;
    throw InputError({path}, "has the keys of no kind of YAML file", kRead);
  }
  if (name.ends_with(".png") || name.ends_with(".pgm")) return text_of_picture(path);
  if (name.ends_with(".obj")) return text_of_mesh(path);
  if (name.ends_with(".truth")) return text_of_truth(path);
  if (name.ends_with(".json")) return text_of_json(path, read_text_file(path));
  const std::string content = read_text_file(path);
  if (content.starts_with("MAPBED TRUTH")) return text_of_truth(path);
  if (content.starts_with("# MAPBED LABELS")) {
    return FileText{"labels of beams", text_of_labels(parse_labels(path, content))};
  }
  if (content.starts_with("track,time,")) {
    return FileText{"tracks", text_of_tracks(parse_tracks(path, content))};
  }
  if (name.ends_with(".csv")) return text_of_table(path, content);
  if (holds_pose_lines(content)) return text_of_pose_lines(path, content);
  return text_of_other_log(path);
}

}  // namespace mapbed
