#include "bench/scenario/log_source.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "bench/simulate.h"
#include "core/config/config_node.h"
#include "core/data_path.h"
#include "core/log/log_description.h"

namespace mapbed {
namespace {

const std::vector<std::string> kNames{"world", "robot", "path", "people", "log"};
const std::vector<std::string> kGroups{"world", "robot", "simulation", "driver", "recorder", "log"};

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_of_source(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? contains(kNames, path) : contains(kGroups, path.substr(0, dot));
}

// The last of these names.
const Setting* named(const Settings& settings, const std::string& path) {
  const Setting* found = nullptr;
  for (const Setting& setting : settings) {
    if (setting.path == path) found = &setting;
  }
  return found;
}

SimulationPlan simulation_plan(const Settings& settings, std::uint64_t seed) {
  SimulationPlan plan;
  plan.seed = seed;
  for (const Setting& setting : settings) {
    if (setting.path == "world") {
      plan.world = setting.text;
    } else if (setting.path == "robot") {
      plan.robot = setting.text;
    } else if (setting.path == "path") {
      plan.path = setting.text;
    } else if (setting.path == "people") {
      plan.people = ConfigNode(setting.text, setting.place).whole_number(at_least(0));
    } else {
      plan.settings.push_back(setting);
    }
  }
  if (plan.world.empty() || plan.robot.empty()) {
    const Place place = settings.empty() ? Place{} : settings.back().place;
    throw InputError({place.file, 0}, "there is no log to work on",
                     "give 'world' and 'robot' for a simulated one, or 'log' for a recorded one");
  }
  return plan;
}

class SimulatedLog : public LogSource {
 public:
  SimulatedLog(const Settings& settings, std::uint64_t seed)
      : simulation_(prepare_simulation(simulation_plan(settings, seed))),
        recording_(record(simulation_)),
        truth_(trajectory_of(recording_.truth)) {}

  double recorded_seconds() const override {
    return truth_.empty() ? 0.0 : truth_.back().time - truth_.front().time;
  }

  RunInput input(const Settings& settings, std::uint64_t seed) const override {
    RunInput input;
    const Robot robot = robot_with_noise(simulation_plan(settings, seed));
    input.log = with_noise(recording_, robot, Rng(seed));
    input.truth = truth_;
    input.recording = &recording_;
    input.world = &simulation_.world;
    input.true_map = [this](double resolution) -> const TrueMap& { return true_map(resolution); };
    input.rng = Rng(seed);
    return input;
  }

 private:
  const TrueMap& true_map(double resolution) const {
    const std::scoped_lock lock(mutex_);
    const auto found = true_maps_.find(resolution);
    if (found != true_maps_.end()) return found->second;
    RasterOptions options{.resolution = resolution};
    options.height = simulation_.robot.lasers.front().height;
    return true_maps_.emplace(resolution, raster(simulation_.world, options)).first->second;
  }

  PreparedSimulation simulation_;
  Recording recording_;
  Trajectory truth_;
  mutable std::mutex mutex_;
  mutable std::map<double, TrueMap> true_maps_;  // by resolution; references stay valid
};

// "log" and its options without "log." in front.
std::string log_path_of(const Settings& settings) {
  const std::string name = named(settings, "log")->text;
  const bool is_file = name.find('/') != std::string::npos || std::filesystem::exists(name);
  return is_file ? name : find_data_file("log", "scenarios/logs", name).string();
}

Settings log_options_of(const Settings& settings) {
  Settings options;
  for (Setting setting : settings) {
    if (setting.path == "log") continue;
    if (!setting.path.starts_with("log.")) {
      throw InputError(setting.place, in_quotes(setting.path) + " says nothing to a recorded log",
                       "take it out, or take 'log' out to simulate one");
    }
    setting.path.erase(0, 4);
    options.push_back(std::move(setting));
  }
  return options;
}

class RecordedSource : public LogSource {
 public:
  explicit RecordedSource(const Settings& settings)
      : log_(open_log(log_path_of(settings), log_options_of(settings))) {}

  double recorded_seconds() const override {
    return time_of(log_.measurements.back()) - time_of(log_.measurements.front());
  }
  RunInput input(const Settings& /*settings*/, std::uint64_t seed) const override {
    RunInput input;
    input.log = log_.measurements;
    input.truth = log_.true_poses;
    input.rng = Rng(seed);
    return input;
  }

 private:
  RecordedLog log_;
};

SourcePlan plan_recorded(const Settings& settings) {
  SourcePlan plan;
  LogOptions options;
  apply(log_options_of(settings), options_of(options), "log");
  plan.complete_yaml = "log: " + named(settings, "log")->text + "\n" + to_yaml(options_of(options));
  (void)log_path_of(settings);
  plan.key = plan.complete_yaml;
  plan.depends_on_seed = false;
  return plan;
}

}  // namespace

DividedSettings divided(const Settings& settings) {
  DividedSettings result;
  for (const Setting& setting : settings) {
    (is_of_source(setting.path) ? result.source : result.experiment).push_back(setting);
  }
  return result;
}

SourcePlan plan_source(const Settings& settings) {
  if (named(settings, "log") != nullptr) return plan_recorded(settings);
  const PreparedSimulation simulation = prepare_simulation(simulation_plan(settings, 0));
  return {simulation.config, simulation.noiseless_config, true};
}

std::unique_ptr<LogSource> open_source(const Settings& settings, std::uint64_t seed) {
  if (named(settings, "log") != nullptr) return std::make_unique<RecordedSource>(settings);
  return std::make_unique<SimulatedLog>(settings, seed);
}

}  // namespace mapbed
