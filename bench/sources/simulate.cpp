#include "bench/sources/simulate.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "bench/process/foreign_files.h"
#include "bench/sources/files_record.h"
#include "bench/sources/simulated_log.h"
#include "core/config/config_node.h"
#include "core/config/yaml_scalar.h"
#include "core/file/atomic_file.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/map_server.h"
#include "core/log/bags/bag_writer.h"
#include "core/log/log_file.h"
#include "sim/noise/sensor_noise.h"
#include "sim/relations.h"
#include "sim/truth/truth_file.h"
#include "worlds/geometry/raster.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

// Everything about a simulation that can be set, but the options of its world and its driver.
struct Options {
  Robot& robot;
  SimulationOptions simulation = {};
  RecorderOptions recorder = {};
};

template <class Visitor>
void visit_fields(Options& o, Visitor&& visit) {
  visit("robot", o.robot, "what drives");
  visit("simulation", o.simulation, "how the world goes on");
  visit("recorder", o.recorder, "what is recorded");
}

// Settings divided by the group that they begin with, which is cut off: "world.seed" is the world's
// "seed".
struct DividedSettings {
  Settings world;
  Settings driver;
  Settings faults;  // whole
  Settings others;  // whole
};

DividedSettings by_group(const Settings& all) {
  DividedSettings result;
  for (Setting setting : all) {
    const std::size_t dot = setting.path.find('.');
    const std::string group = setting.path.substr(0, dot);
    const bool is_world = group == "world";
    if (group == "faults") {
      result.faults.push_back(std::move(setting));
      continue;
    }
    if (dot == std::string::npos || (!is_world && group != "driver")) {
      result.others.push_back(std::move(setting));
      continue;
    }
    setting.path.erase(0, dot + 1);
    (is_world ? result.world : result.driver).push_back(std::move(setting));
  }
  return result;
}

// A driver who is told measurements reacts to their noise, which then belongs to the recording.
Robot without_noise(Robot robot, const RecorderOptions& recorder) {
  if (recorder.tells_driver) return robot;
  const OdometryModel given = robot.odometry;
  robot.odometry = {};
  robot.odometry.rate = given.rate;
  for (MountedSensor& sensor : robot.sensors) {
    std::visit([](auto& model) { model.noise = {}; }, sensor.model);
  }
  return robot;
}

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
    std::filesystem::remove(path);
  } else {
    write_text_file(path, text);
  }
}

constexpr const char* kConfig = ".config.yaml";
constexpr const char* kBeside[] = {kConfig, ".truth.gz", ".relations",
                                   ".tum",  "_map.pgm",  "_map.yaml"};

// The configuration first: it says whose the others are, also after a kill.
void write_beside(const std::string& stem, const SimulationResult& result,
                  const Trajectory& truth) {
  write_text_file(stem + kConfig,
                  fmt::format("seed: {}\n", result.seed) + result.simulation.config +
                      result.simulation.faults.complete_yaml + files_yaml(result.simulation.files));
  write_truth(stem + ".truth.gz", result.recording.truth);
  write_relations(stem + ".relations", truth);
  write_trajectory(stem + ".tum", truth);
  write_true_map(stem, result.simulation);
}

// Whether that configuration is one that write_beside has written.
bool is_of_simulation(const std::string& path) {
  if (!std::filesystem::exists(path)) return false;
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
  if (!std::filesystem::exists(folder)) return;
  if (!std::filesystem::is_directory(folder)) {
    throw InputError({folder}, "is a file, and bags of ROS 2 are folders", "name a folder");
  }
  const auto files = files_of_rosbag2(folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const bool is_coming =
        std::find(files.begin(), files.end(), entry.path().string()) != files.end();
    if (!is_ours || !is_coming) refuse_foreign(entry.path().string());
  }
}

}  // namespace

const SimulationParts::BuiltWorld& SimulationParts::world(const std::string& name,
                                                          const Settings& settings) {
  std::string key = name;
  for (const Setting& setting : settings) key += "\n" + setting.path + "=" + setting.text;
  const auto found = worlds_.find(key);
  if (found != worlds_.end()) return found->second;
  const Configured<World()> configured = configure_world(name, settings);
  return worlds_[key] = {configured.complete_yaml, std::make_shared<const World>(configured.make()),
                         configured.files};
}

const Robot& SimulationParts::robot(const std::string& name) {
  const auto found = robots_.find(name);
  return found != robots_.end() ? found->second
                                : robots_.emplace(name, load_robot(name)).first->second;
}

PreparedSimulation prepare_simulation(const SimulationPlan& plan, SimulationParts& parts) {
  DividedSettings settings = by_group(plan.settings);
  const auto& [world_yaml, world, world_files] = parts.world(plan.world, settings.world);
  if (world->paths.empty()) {
    throw InputError("world '" + plan.world + "' has no path to drive; add one to its paths");
  }
  PreparedSimulation prepared{.world = world, .robot = parts.robot(plan.robot)};
  prepared.files = world_files;
  exchange_sensors(settings.others, prepared.robot);
  merge(prepared.robot.files, prepared.files);
  prepared.path = plan.path.empty() ? world->paths.front() : path_by_name(*world, plan.path);
  Options options{.robot = prepared.robot};
  if (plan.people >= 0) {
    CrowdOptions& people = options.simulation.actors.people;
    people = with_people(people, world->crowd, plan.people);
  }
  apply(settings.others, options_of(options), "the simulation");
  check_robot(prepared.robot, {});
  if (lasers_of(prepared.robot).empty()) {
    throw InputError("robot '" + plan.robot + "' has no laser; add one to its sensors");
  }
  const DriveKind drive = prepared.robot.drive.kind;
  const std::string driver_name = plan.driver.empty() ? usual_driver(drive) : plan.driver;
  if (!driver_by_name(driver_name).can_drive(drive)) {
    throw InputError("driver '" + driver_name + "' cannot drive robot '" + plan.robot + "' (" +
                     name_of(drive) + "); take driver '" + usual_driver(drive) + "'");
  }
  const Configured<MakeDriver> driver = configure_driver(driver_name, settings.driver);
  prepared.simulation = options.simulation;
  prepared.recorder = options.recorder;
  prepared.make_driver = driver.make;
  prepared.faults = plan_faults(settings.faults);

  const std::string given = fmt::format(
      "world: {}\n{}robot: {}\npath: {}\ndriver: {}\n{}", yaml_scalar(plan.world),
      dotted("world", world_yaml), yaml_scalar(plan.robot), yaml_scalar(prepared.path.name),
      yaml_scalar(driver_name), dotted("driver", driver.complete_yaml));
  const auto config_with = [&](Robot robot) {
    Options complete{robot, options.simulation, options.recorder};
    return given + dotted("", to_yaml(options_of(complete)));
  };
  prepared.config = config_with(prepared.robot);
  prepared.noiseless_config = config_with(without_noise(prepared.robot, prepared.recorder));
  return prepared;
}

PreparedSimulation prepare_simulation(const SimulationPlan& plan) {
  SimulationParts parts;
  return prepare_simulation(plan, parts);
}

namespace {

// Tells how far the robot has come, and hands on what it is told.
std::function<void(StampedStates&&)> watched(std::function<void(StampedStates&&)> take,
                                             const Driven& driven) {
  if (!driven) return take;
  return [take = std::move(take), &driven, meters = 0.0,
          last = std::optional<Pose2>()](StampedStates&& states) mutable {
    const Pose2& now = states.world_from_robot;
    if (last) meters += std::hypot(now.x - last->x, now.y - last->y);
    last = now;
    driven(meters);
    take(std::move(states));
  };
}

Recording record(const PreparedSimulation& prepared, std::uint64_t seed, const GoesOn& goes_on,
                 const Driven& driven) {
  const Rng rng(seed);
  Simulation simulation(*prepared.world, prepared.robot, start_of(prepared.path),
                        prepared.simulation, rng);
  const std::unique_ptr<Driver> driver = prepared.make_driver(simulation, prepared.path);
  RecorderOptions options = prepared.recorder;
  options.longest = std::min(options.longest, driver->longest_time());
  Recording recording;
  static_cast<TruthHeader&>(recording.truth) = simulation.truth_header();
  RecordingSink sink = sink_into(recording);
  sink.reading = [&goes_on, take = sink.reading](IdealReading reading) {
    throw_unless(goes_on);
    take(std::move(reading));
  };
  sink.states = watched(std::move(sink.states), driven);
  recording.end = record(simulation, *driver, options, rng, sink);
  return recording;
}

}  // namespace

Recording record(const PreparedSimulation& prepared, std::uint64_t seed, const GoesOn& goes_on) {
  return record(prepared, seed, goes_on, {});
}

SimulationResult run_simulation(const SimulationPlan& plan, std::uint64_t seed) {
  return run_simulation(prepare_simulation(plan), seed);
}

SimulationResult run_simulation(PreparedSimulation simulation, std::uint64_t seed) {
  return run_watched_simulation(std::move(simulation), seed, {});
}

bool is_simulated_log(const std::string& log_path) {
  return is_of_simulation(stem_of(log_path) + kConfig);
}

SimulationResult run_watched_simulation(PreparedSimulation simulation, std::uint64_t seed,
                                        const Driven& driven) {
  SimulationResult result{.simulation = std::move(simulation), .seed = seed};
  result.recording = record(result.simulation, seed, {}, driven);
  result.log = with_noise(result.recording.readings, result.simulation.robot, Rng(seed));
  const PlannedFaults& faults = result.simulation.faults;
  if (faults.planned.empty()) return result;
  const Trajectory truth = trajectory_of(result.recording.truth);
  result.log = broken(std::move(result.log), truth, faults, Rng(seed)).log;
  return result;
}

void write_simulation(const std::string& log_path, const SimulationResult& result,
                      const LogFormat& format) {
  const Trajectory truth = trajectory_of(result.recording.truth);
  if (format.is_folder || !is_special_file(log_path)) {  // else nothing stands beside it
    // Behind a link, which stays.
    for (const std::string& file : files_of(log_path, format)) {
      if (std::filesystem::exists(file)) {
        std::filesystem::remove(std::filesystem::canonical(file));
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
  const std::filesystem::path stem = stem_of(log_path);
  const bool is_ours = is_of_simulation(stem.string() + kConfig);
  if (format.is_folder) refuse_foreign_folder(log_path, is_ours);
  std::vector<std::string> coming;
  for (const char* ending : kBeside) coming.push_back(stem.filename().string() + ending);
  refuse_foreign(stem.parent_path().string(), coming,
                 is_ours ? coming : std::vector<std::string>{});
}

}  // namespace mapbed
