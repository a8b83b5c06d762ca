#include "bench/sources/simulate.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/config/config_node.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/map_server.h"
#include "core/log/dialects/carmen_log.h"
#include "sim/relations.h"
#include "worlds/geometry/raster.h"
#include "worlds/worlds.h"

namespace mapbed {
namespace {

// Everything about a simulation that can be set, but the world's own options.
struct Options {
  Robot& robot;
  SimulationOptions simulation;
  ScriptedDriverOptions driver;
  RecorderOptions recorder;
};

template <class Visitor>
void visit_fields(Options& o, Visitor&& visit) {
  visit("robot", o.robot, "what drives");
  visit("simulation", o.simulation, "how the world goes on");
  visit("driver", o.driver, "how it is driven");
  visit("recorder", o.recorder, "what is recorded");
}

// Divides settings by what they begin with: "world.seed" is the world's "seed".
Settings settings_of_world(const Settings& all) {
  Settings result;
  for (Setting setting : all) {
    if (!setting.path.starts_with("world.")) continue;
    setting.path = setting.path.substr(6);
    result.push_back(setting);
  }
  return result;
}

Settings settings_of_others(const Settings& all) {
  Settings result;
  for (const Setting& setting : all) {
    if (!setting.path.starts_with("world.")) result.push_back(setting);
  }
  return result;
}

// A driver who is told measurements reacts to their noise, which then belongs to the recording.
Robot without_noise(Robot robot, const RecorderOptions& recorder) {
  if (recorder.tells_driver) return robot;
  const OdometryModel given = robot.odometry;
  robot.odometry = {};
  robot.odometry.rate = given.rate;
  for (MountedLaser& laser : robot.lasers) laser.model.noise = {};
  return robot;
}

// "dir/name.log.gz" -> "dir/name"
std::string stem_of(std::string path) {
  for (const char* ending : {".gz", ".log", ".clf"}) {
    if (path.ends_with(ending)) path.resize(path.size() - std::string(ending).size());
  }
  return path;
}

void write_true_map(const std::string& stem, const PreparedSimulation& simulation) {
  RasterOptions options;
  options.height = simulation.robot.lasers.front().height;
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

}  // namespace

const SimulationParts::BuiltWorld& SimulationParts::world(const std::string& name,
                                                          const Settings& settings) {
  const Configured<World()> configured = configure_world(name, settings);
  const auto [found, is_new] = worlds_.try_emplace(name + "\n" + configured.complete_yaml);
  if (is_new) {
    found->second = {configured.complete_yaml, std::make_shared<const World>(configured.make())};
  }
  return found->second;
}

const Robot& SimulationParts::robot(const std::string& name) {
  const auto found = robots_.find(name);
  return found != robots_.end() ? found->second
                                : robots_.emplace(name, load_robot(name)).first->second;
}

PreparedSimulation prepare_simulation(const SimulationPlan& plan, SimulationParts& parts) {
  const auto& [world_yaml, world] = parts.world(plan.world, settings_of_world(plan.settings));
  PreparedSimulation prepared{.world = world, .robot = parts.robot(plan.robot)};
  Options options{.robot = prepared.robot, .simulation = {}, .driver = {}, .recorder = {}};
  if (plan.people >= 0) {
    options.simulation.people = with_people(options.simulation.people, world->crowd, plan.people);
  }
  apply(settings_of_others(plan.settings), options_of(options), "the simulation");
  if (world->paths.empty()) {
    throw InputError("world '" + plan.world + "' has no path to drive; add one to its paths");
  }
  if (prepared.robot.lasers.empty()) {
    throw InputError("robot '" + plan.robot + "' has no laser; add one to its lasers");
  }
  prepared.path = plan.path.empty() ? world->paths.front() : path_by_name(*world, plan.path);
  prepared.simulation = options.simulation;
  prepared.driver = options.driver;
  prepared.recorder = options.recorder;
  const std::string names = fmt::format("world: {}\npath: {}\nworld_options:\n{}", plan.world,
                                        prepared.path.name, indented(world_yaml));
  prepared.config = names + to_yaml(options_of(options));
  Robot noiseless = without_noise(prepared.robot, prepared.recorder);
  Options rest{.robot = noiseless,
               .simulation = options.simulation,
               .driver = options.driver,
               .recorder = options.recorder};
  prepared.noiseless_config = names + to_yaml(options_of(rest));
  return prepared;
}

PreparedSimulation prepare_simulation(const SimulationPlan& plan) {
  SimulationParts parts;
  return prepare_simulation(plan, parts);
}

Recording record(const PreparedSimulation& prepared, std::uint64_t seed) {
  const Rng rng(seed);
  Simulation simulation(*prepared.world, prepared.robot, start_of(prepared.path),
                        prepared.simulation, rng);
  ScriptedDriver driver(simulation, prepared.path, prepared.driver);
  RecorderOptions options = prepared.recorder;
  options.longest = std::min(options.longest, driver.longest_time());
  return record(simulation, driver, options, rng);
}

SimulationResult run_simulation(const SimulationPlan& plan, std::uint64_t seed) {
  return run_simulation(prepare_simulation(plan), seed);
}

SimulationResult run_simulation(PreparedSimulation simulation, std::uint64_t seed) {
  SimulationResult result{.simulation = std::move(simulation), .seed = seed};
  result.recording = record(result.simulation, seed);
  result.log = with_noise(result.recording, result.simulation.robot, Rng(seed));
  return result;
}

void write_simulation(const std::string& log_path, const SimulationResult& result) {
  const Trajectory truth = trajectory_of(result.recording.truth);
  RecordedLog log;
  log.format = "CARMEN";
  log.measurements = result.log;
  log.true_poses = truth;
  write_carmen_log(log_path, log);
  const std::string stem = stem_of(log_path);
  write_truth(stem + ".truth.gz", result.recording.truth);
  write_text_file(stem + ".relations", relations_text(truth));
  write_trajectory(stem + ".tum", truth);
  write_text_file(stem + ".config.yaml",
                  fmt::format("seed: {}\n", result.seed) + result.simulation.config);
  write_true_map(stem, result.simulation);
}

}  // namespace mapbed
