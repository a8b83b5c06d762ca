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

SimulationResult run_watched_simulation(PreparedSimulation simulation, std::uint64_t seed,
                                        const Driven& driven) {
  SimulationResult result{.simulation = std::move(simulation), .seed = seed};
  result.recording = record(result.simulation, seed, {}, driven);
  result.log = with_noise(result.recording.readings, result.simulation.robot, Rng(seed));
  result.recording.truth.reads =
      true_reads(result.recording.readings, result.simulation.robot, Rng(seed));
  const PlannedFaults& faults = result.simulation.faults;
  if (faults.planned.empty()) return result;
  const Trajectory truth = trajectory_of(result.recording.truth);
  result.log = broken(std::move(result.log), truth, faults, Rng(seed)).log;
  return result;
}

}  // namespace mapbed
