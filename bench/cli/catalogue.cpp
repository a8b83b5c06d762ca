#include "bench/cli/catalogue.h"

#include <algorithm>

#include <fmt/format.h>

#include "algorithms/beam_filters.h"
#include "algorithms/grid/map_builder.h"
#include "algorithms/input/geometry_check.h"
#include "algorithms/methods.h"
#include "bench/cli/describe/file_text.h"
#include "bench/cli/describe/words.h"
#include "bench/cli/describe/world_text.h"
#include "bench/cli/graph_run.h"
#include "bench/experiments/experiment.h"
#include "bench/faults/faults.h"
#include "bench/methods/program_method.h"
#include "bench/scenario/scenario.h"
#include "core/config/config_node.h"
#include "core/config/quantity.h"
#include "core/data_path.h"
#include "core/file/text_file.h"
#include "core/log/log_description.h"
#include "core/log/log_formats.h"
#include "core/log/log_options.h"
#include "core/log/public_log.h"
#include "robots/robot.h"
#include "robots/sensor_model.h"
#include "sim/drivers/drivers.h"
#include "sim/render/render_world.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

std::vector<CatalogueEntry> method_entries() {
  std::vector<CatalogueEntry> entries;
  for (const Method& method : methods()) {
    entries.push_back(
        {method.name, method.about, [&method] { return method.configure({}).complete_yaml; }});
  }
  for (const std::string& name : program_method_names()) {
    const std::string path = find_data_file("method", "scenarios/methods", name).string();
    const ConfigNode file = load_config(path);
    const ConfigNode* about = file.find("about");
    entries.push_back({name, about != nullptr ? about->text() : "a program",
                       [path] { return read_text_file(path); }});
  }
  return entries;
}

std::vector<CatalogueEntry> filter_entries() {
  std::vector<CatalogueEntry> entries;
  for (const BeamFilterEntry& filter : beam_filters()) {
    entries.push_back(
        {filter.name, filter.about, [&filter] { return filter.configure({}).complete_yaml; }});
  }
  return entries;
}

std::vector<CatalogueEntry> world_entries() {
  std::vector<CatalogueEntry> entries;
  for (const WorldKind& kind : world_kinds()) {
    entries.push_back({kind.name, kind.about, [&kind] {
                         const auto world = kind.configure({});
                         return text_of_world(world.make()) + "options:\n" +
                                indented(world.complete_yaml);
                       }});
  }
  for (const std::string& name : world_file_names()) {
    const std::string path = find_data_file("world", "worlds", name).string();
    const ConfigNode file = load_config(path);
    const ConfigNode* about = file.find("about");
    entries.push_back({name, about != nullptr ? about->text() : "a world file", [path] {
                         return text_of_world(build_world(path)) + "file: " + path + "\n" +
                                indented(read_text_file(path));
                       }});
  }
  return entries;
}

std::vector<CatalogueEntry> robot_entries() {
  std::vector<CatalogueEntry> entries;
  for (const std::string& name : robot_names()) {
    entries.push_back({name, load_robot(name).about, [name] { return text_of_robot(name).text; },
                       promise_of_robot(name)});
  }
  return entries;
}

std::vector<CatalogueEntry> sensor_entries() {
  std::vector<CatalogueEntry> entries;
  for (const std::string& name : sensor_names()) {
    const SensorModel sensor = load_sensor(name);
    entries.push_back({name, std::visit([](const auto& model) { return model.about; }, sensor),
                       [name] { return text_of_sensor(name).text; }, promise_of_sensor(name)});
  }
  return entries;
}

std::string text_of(const PublicLog& log) {
  std::string text;
  if (!log.cite.empty()) text += "cite: " + log.cite + "\n";
  if (!log.pieces.empty()) text += "public files:\n";
  for (const PublicFile& piece : log.pieces) {
    const std::string bytes = piece.bytes == 0 ? "?" : fmt::to_string(piece.bytes);
    text += fmt::format("  - {}: {} bytes, SHA-256 {}, opened: {}\n", piece.file, bytes,
                        piece.sha256.empty() ? "unknown" : piece.sha256, piece.opened);
    for (const std::string& address : piece.addresses) text += "    " + address + "\n";
  }
  for (const MadeFile& made : log.made) {
    text += fmt::format("made by fetch: {} of {} ({})\n", made.file, made.piece, made.by);
  }
  if (!log.by_hand.empty()) text += "by hand:\n";
  for (const std::string& step : log.by_hand) text += "  - " + step + "\n";
  return text;
}

std::string text_of(const LogDescription& log) {
  std::string text = "file: " + log.log.file + "\nsha256: " + log.log.sha256 +
                     "\nsource: " + log.source + "\nlicence: " + log.licence +
                     "\nfetch: " + log.fetch + "\nrobot: " + log.robot + "\nlaser: " + log.laser +
                     "\n";
  if (!log.pieces.empty()) text += "pieces:\n";
  for (const std::string& piece : log.pieces) text += "  - " + piece + "\n";
  text += text_of(load_public_log(log.yaml_path));
  return is_here(log) ? text + text_of_log(log.yaml_path) : text;
}

// What it is, and where it is not here how to come to it.
std::string about_of(const std::string& name, const LogDescription& log) {
  if (is_here(log)) return log.about;
  return fmt::format("{} (not here: 'mapbed fetch {}' {})", log.about, name,
                     can_be_fetched(log) ? "gets it" : "says how to get it");
}

std::vector<CatalogueEntry> driver_entries() {
  std::vector<CatalogueEntry> entries;
  for (const DriverKind& kind : driver_kinds()) {
    entries.push_back(
        {kind.name, kind.about, [&kind] { return kind.configure({}).complete_yaml; }});
  }
  return entries;
}

std::vector<CatalogueEntry> format_entries() {
  std::vector<CatalogueEntry> entries;
  for (const LogFormat& format : log_formats()) {
    const std::string text = std::string("files: NAME") + format.extension + "\n";
    entries.push_back({format.name, format.about, [text] { return text; }});
  }
  return entries;
}

std::vector<CatalogueEntry> log_entries() {
  std::vector<CatalogueEntry> entries;
  for (const std::string& name : data_names("scenarios/logs")) {
    const std::string path = find_data_file("log", "scenarios/logs", name).string();
    const LogDescription log = load_log_description(path);
    entries.push_back({name, about_of(name, log), [log] { return text_of(log); }});
  }
  return entries;
}

std::vector<CatalogueEntry> scenario_entries() {
  std::vector<CatalogueEntry> entries;
  for (const std::string& name : scenario_names()) {
    entries.push_back({name, load_scenario(name).about, [name] {
                         return read_text_file(find_data_file("scenario", "scenarios", name));
                       }});
  }
  return entries;
}

std::string text_of(const Experiment& experiment) {
  const auto line = [](const std::string& name, const std::string& about, Unit unit) {
    return "  " + name + "  # " + about + (unit == Unit::none ? "" : ", " + unit_name(unit)) + "\n";
  };
  std::string text;
  for (const std::string& log : experiment.further_logs) text += "further log: " + log + "\n";
  text += "metrics:\n";
  for (const Metric& metric : experiment.metrics) {
    text += line(metric.name, metric.about, metric.unit);
  }
  if (!experiment.series.empty()) text += "series, which stand among a scenario's metrics:\n";
  for (const SeriesMetric& series : experiment.series) {
    text += line(series.name, "over " + series.x_name + ": " + series.about, series.unit);
  }
  return text + "options:\n" + experiment.configure({}).complete_yaml;
}

std::vector<CatalogueEntry> fault_entries() {
  std::vector<CatalogueEntry> entries;
  for (const Fault& fault : faults()) {
    entries.push_back({fault.name, fault.about, [&fault] {
                         return dotted("faults." + fault.name, fault.configure({}).complete_yaml);
                       }});
  }
  return entries;
}

std::vector<CatalogueEntry> experiment_entries() {
  std::vector<CatalogueEntry> entries;
  for (const Experiment& experiment : experiments()) {
    entries.push_back({experiment.name, experiment.about + "; needs " + text_of(experiment.needs),
                       [&experiment] { return text_of(experiment); }});
  }
  return entries;
}

template <class Options>
std::string defaults_of() {
  Options options;
  return to_yaml(options_of(options));
}

std::vector<CatalogueEntry> setting_entries() {
  return {{"camera", "how a picture of a world is taken", defaults_of<RenderOptions>},
          {"graph_file", "how 'mapbed graph' optimises a file", defaults_of<GraphConfig>},
          {"log", "how a recorded log is read", defaults_of<LogOptions>},
          {"map", "how a map is made of scans and poses", defaults_of<MapOptions>}};
}

}  // namespace

const std::vector<CatalogueShelf>& catalogue() {
  static const std::vector<CatalogueShelf> shelves = [] {
    std::vector<CatalogueShelf> all{
        {"scenarios", "scenario", scenario_entries},
        {"experiments", "experiment", experiment_entries},
        {"worlds", "world", world_entries},
        {"robots", "robot", robot_entries},
        {"sensors", "sensor", sensor_entries},
        {"drivers", "driver", driver_entries},
        {"methods", "method", method_entries},
        {"filters", "people filter", filter_entries},
        {"logs", "log", log_entries},
        {"formats", "format of logs", format_entries},
        {"faults", "fault", fault_entries},
        {"settings", "setting", setting_entries},
    };
    for (CatalogueShelf& shelf : word_shelves()) all.push_back(std::move(shelf));
    return all;
  }();
  return shelves;
}

std::string text_of_bag(const BagContents& bag) {
  std::string text =
      fmt::format("format: {}\nrecorded: {:.1f} s\ntopics:\n", bag.format, bag.seconds);
  for (const RecordedTopic& topic : bag.topics)
    text += fmt::format("  - {}: {} {}{}\n", topic.name, topic.messages, topic.type,
                        topic.unread.empty() ? "" : ", not read: " + topic.unread);
  return text;
}

std::string text_of_log(const std::string& path) {
  RecordedLog log = open_log(path);
  std::vector<Remark> remarks = choose_geometry(log);
  for (Remark& remark : remarks_on_geometry(log.measurements)) {
    remarks.push_back(std::move(remark));
  }
  const double seconds = time_of(log.measurements.back()) - time_of(log.measurements.front());
  std::size_t scans = 0, readings = 0, rounds = 0, reads = 0;
  for (const Measurement& m : log.measurements) {
    if (std::holds_alternative<LaserScan>(m)) ++scans;
    if (std::holds_alternative<Odometry>(m)) ++readings;
    const auto* round = std::get_if<RfidDetections>(&m);
    if (round == nullptr) continue;
    ++rounds;
    reads += round->reads.size();
  }
  std::string text =
      fmt::format("format: {}\nmeasurements: {} scans and {} odometry readings in {:.1f} s\n",
                  log.format, scans, readings, seconds);
  if (rounds > 0) text += fmt::format("RFID: {} rounds, {} reads of tags\n", rounds, reads);
  text += "lasers:\n";
  for (const RecordedLaser& laser : log.lasers) text += "  - " + to_string(laser) + "\n";
  for (const Remark& remark : remarks) text += "remark: " + remark.text + "\n";
  for (const LogWarning& warning : log.warnings) text += "warning: " + to_string(warning) + "\n";
  return text;
}

}  // namespace mapbed
