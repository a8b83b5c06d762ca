#include "bench/sources/log_source.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "core/config/config_node.h"
#include "core/data_path.h"
#include "core/geometry/tum_file.h"
#include "core/log/log_description.h"
#include "sim/relations.h"

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

class SimulatedLog : public LogSource {
 public:
  SimulatedLog(std::shared_ptr<const PreparedSimulation> simulation, std::uint64_t seed)
      : simulation_(std::move(simulation)),
        recording_(record(*simulation_, seed)),
        truth_(trajectory_of(recording_.truth)) {}

  double recorded_seconds() const override {
    return truth_.empty() ? 0.0 : truth_.back().time - truth_.front().time;
  }

  RunInput input(const SourcePlan& plan, std::uint64_t seed) const override {
    RunInput input;
    input.log = with_noise(recording_, plan.simulation->robot, Rng(seed));
    input.truth = truth_;
    input.recording = &recording_;
    input.world = simulation_->world.get();
    input.true_map = [this](double resolution) -> const TrueMap& { return true_map(resolution); };
    input.relations = [this]() -> const MeasuredRelations& { return relations(); };
    input.rng = Rng(seed);
    return input;
  }

 private:
  const TrueMap& true_map(double resolution) const {
    const std::scoped_lock lock(mutex_);
    const auto found = true_maps_.find(resolution);
    if (found != true_maps_.end()) return found->second;
    RasterOptions options{.resolution = resolution};
    options.height = simulation_->robot.lasers.front().height;
    return true_maps_.emplace(resolution, raster(*simulation_->world, options)).first->second;
  }

  // Those that `mapbed simulate` writes beside a log.
  const MeasuredRelations& relations() const {
    const std::scoped_lock lock(mutex_);
    if (!relations_) {
      const std::string text = relations_text(truth_);
      relations_.emplace();
      if (!text.empty()) relations_->relations = parse_relations("true relations", text);
    }
    return *relations_;
  }

  std::shared_ptr<const PreparedSimulation> simulation_;
  Recording recording_;
  Trajectory truth_;
  mutable std::mutex mutex_;
  mutable std::optional<MeasuredRelations> relations_;
  mutable std::map<double, TrueMap> true_maps_;  // by resolution; references stay valid
};

// The log's own path, or that of its description.
std::string log_path_of(const Settings& settings) {
  const Setting& log = *named(settings, "log");
  const bool is_path = log.text.find('/') != std::string::npos || std::filesystem::exists(log.text);
  if (!is_path) return find_data_file("log", "scenarios/logs", log.text).string();
  if (std::filesystem::is_regular_file(log.text)) return log.text;
  throw InputError(log.place, in_quotes(log.text) + " is no file",
                   "give the path of a log or one of the names that 'mapbed list logs' shows");
}

std::optional<LogDescription> description_of(const std::string& log_path) {
  if (!log_path.ends_with(".yaml")) return {};
  return load_log_description(log_path);
}

// Without "log." in front.
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
      : description_(description_of(log_path_of(settings))),
        log_(open_log(log_path_of(settings), log_options_of(settings))) {}

  double recorded_seconds() const override {
    return time_of(log_.measurements.back()) - time_of(log_.measurements.front());
  }
  RunInput input(const SourcePlan& /*plan*/, std::uint64_t seed) const override {
    RunInput input;
    input.log = log_.measurements;
    input.truth = log_.true_poses;
    if (description_ && !description_->relations.file.empty()) {
      input.relations = [this]() -> const MeasuredRelations& { return relations(); };
    }
    input.rng = Rng(seed);
    return input;
  }

 private:
  const MeasuredRelations& relations() const {
    const std::scoped_lock lock(mutex_);
    if (relations_) return *relations_;
    MeasuredRelations measured;
    measured.relations = load_relations(find_stored(*description_, description_->relations));
    const StoredFile& odometry = description_->relations_odometry;
    if (!odometry.file.empty()) {
      measured.odometry = load_trajectory(find_stored(*description_, odometry));
    }
    return relations_.emplace(std::move(measured));
  }

  std::optional<LogDescription> description_;
  RecordedLog log_;
  mutable std::mutex mutex_;
  mutable std::optional<MeasuredRelations> relations_;
};

SourcePlan plan_recorded(const Settings& settings) {
  SourcePlan plan;
  const std::string name = named(settings, "log")->text;
  const std::optional<LogDescription> description = description_of(log_path_of(settings));
  LogOptions options = description ? description->options : LogOptions{};
  apply(log_options_of(settings), options_of(options), "log");
  plan.complete_yaml = "log: " + name + "\n";
  if (description) plan.complete_yaml += "sha256: " + description->log.sha256 + "\n";
  plan.complete_yaml += to_yaml(options_of(options));
  plan.key = plan.complete_yaml;
  plan.settings = settings;
  plan.depends_on_seed = false;
  if (description && !is_here(*description)) {
    plan.missing = fmt::format("the log '{}' is not here ({})", name, description->log.file);
  }
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

SimulationPlan simulation_plan(const Settings& settings) {
  SimulationPlan plan;
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
    const SourceLocation place = settings.empty() ? SourceLocation{} : settings.back().place;
    throw InputError({place.file, 0}, "there is no log to work on",
                     "give 'world' and 'robot' for a simulated one, or 'log' for a recorded one");
  }
  return plan;
}

SourcePlan plan_source(const Settings& settings, SimulationParts& parts) {
  if (named(settings, "log") != nullptr) return plan_recorded(settings);
  const auto simulation = std::make_shared<const PreparedSimulation>(
      prepare_simulation(simulation_plan(settings), parts));
  return {.complete_yaml = simulation->config,
          .key = simulation->noiseless_config,
          .simulation = simulation};
}

SourcePlan plan_source(const Settings& settings) {
  SimulationParts parts;
  return plan_source(settings, parts);
}

std::unique_ptr<LogSource> open_source(const SourcePlan& plan, std::uint64_t seed) {
  if (plan.simulation == nullptr) return std::make_unique<RecordedSource>(plan.settings);
  return std::make_unique<SimulatedLog>(plan.simulation, seed);
}

}  // namespace mapbed
