#include <filesystem>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/cli/catalogue.h"
#include "bench/cli/describe/file_text.h"
#include "bench/cli/describe/world_text.h"
#include "bench/methods/program_method.h"
#include "bench/scenario/scenario.h"
#include "core/config/config_node.h"
#include "core/file/text_file.h"
#include "core/image/map_server.h"
#include "robots/robot.h"
#include "robots/sensor_model.h"
#include "robots/specification.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

bool has_all(const ConfigNode& file, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (file.find(key) == nullptr) return false;
  }
  return true;
}

bool has_any(const ConfigNode& file, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (file.find(key) != nullptr) return true;
  }
  return false;
}

std::string percent(std::size_t part, std::size_t whole) {
  return fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

FileText text_of_scenario(const std::string& path) {
  const Scenario scenario = load_scenario(path);
  std::string text = "about: " + scenario.about + "\nexperiment: " + scenario.experiment + "\n";
  std::size_t levels = 1;
  for (const SweepAxis& axis : scenario.axes) {
    levels *= axis.texts.size();
    text += fmt::format("sweep: {} over {}\n", axis.path, fmt::join(axis.texts, ", "));
  }
  text += "compare:";
  for (const Variant& variant : scenario.variants) text += " " + variant.name + ";";
  text.back() = '\n';
  const std::size_t runs =
      levels * scenario.variants.size() * static_cast<std::size_t>(scenario.seeds);
  text += fmt::format("runs: {} at most; {} levels, {} variants, {} seeds from {} on\n", runs,
                      levels, scenario.variants.size(), scenario.seeds, scenario.seed);
  text += fmt::format("metrics: {}\nclaims: {}\nplots: {}\n", fmt::join(scenario.metrics, ", "),
                      scenario.claims.size(), scenario.plots.size());
  return {"scenario", text};
}

std::string with_source(const std::string& promise, const std::string& source,
                        const std::string& file) {
  return promise + "; source: " + (source.empty() ? "comments of " + file : source);
}

std::string source_of(const SensorModel& sensor) {
  return std::visit([](const auto& model) { return model.source; }, sensor);
}

}  // namespace

std::string promise_of_sensor(const std::string& name_or_path) {
  const SensorModel sensor = load_sensor(name_or_path);
  return with_source(specification(sensor), source_of(sensor), "the sensor's file");
}

std::string promise_of_robot(const std::string& name_or_path) {
  const Robot robot = load_robot(name_or_path);
  return with_source(specification(robot), robot.source, "the robot's file");
}

FileText text_of_sensor(const std::string& name_or_path) {
  SensorModel sensor = load_sensor(name_or_path);
  return {"sensor", "specification: " + promise_of_sensor(name_or_path) + "\n" +
                        std::visit([](auto& model) { return to_yaml(options_of(model)); }, sensor)};
}

FileText text_of_robot(const std::string& name_or_path) {
  Robot robot = load_robot(name_or_path);
  return {"robot",
          "specification: " + promise_of_robot(name_or_path) + "\n" + to_yaml(options_of(robot))};
}

FileText text_of_map(const std::string& path) {
  const MapServerMap map = read_map_server(path);
  std::size_t occupied = 0;
  std::size_t free = 0;
  const auto& cells = map.occupancy.pixels();
  for (const float cell : cells) {
    if (cell == MapServerMap::kUnknown) continue;
    if (cell > map.thresholds.occupied) ++occupied;
    if (cell < map.thresholds.free) ++free;
  }
  const int width = map.occupancy.width();
  const int height = map.occupancy.height();
  return {"map", fmt::format("image: {}\nsize: {} x {} cells of {:g} m, {:.1f} m x {:.1f} m\n"
                             "lower left corner: ({:g}, {:g}), turned by {:g} rad\n"
                             "known: {} of the cells; {} occupied, {} free\n",
                             read_map_server_file(path).image, width, height, map.resolution,
                             width * map.resolution, height * map.resolution, map.map_from_image.x,
                             map.map_from_image.y, map.map_from_image.theta,
                             percent(occupied + free, cells.size()),
                             percent(occupied, cells.size()), percent(free, cells.size()))};
}

std::optional<FileText> text_of_yaml(const std::string& path) {
  const ConfigNode file = load_config(path);
  if (file.kind() != ConfigNode::Kind::map) return {};
  if (has_all(file, {"image", "resolution"})) return text_of_map(path);
  if (has_any(file, {"command", "shell"})) {
    return FileText{"method", load_program_method(path).description()};
  }
  if (has_all(file, {"file", "sha256"})) return FileText{"log", text_of_log(path)};
  if (has_any(file, {"map_file"})) {
    return FileText{"configuration of a map; 'mapbed map LOG --config' repeats it",
                    read_text_file(path)};
  }
  if (has_all(file, {"scenario", "settings"})) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return text_of_results(folder.empty() ? "." : folder.string());
  }
  if (has_any(file, {"footprint", "drive"})) return text_of_robot(path);
  if (has_any(file, {"beams", "bearing_step", "scan_rate"})) return text_of_sensor(path);
  if (has_any(file, {"start", "plan", "floor", "walls", "shapes"})) {
    return FileText{"world", text_of_world(build_world(path))};
  }
  if (has_any(file, {"experiment", "world", "log", "compare", "sweep", "base", "metrics"})) {
    return text_of_scenario(path);
  }
  return {};
}

}  // namespace mapbed
