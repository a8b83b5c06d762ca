#include "bench/sources/recorded_source.h"

#include <filesystem>
#include <mutex>

#include <fmt/format.h>

#include "bench/sources/source_settings.h"
#include "core/data_path.h"
#include "core/geometry/tum_file.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// The log's own path, or that of its description.
std::string path_of(const Setting& log) {
  const bool is_path = log.text.find('/') != std::string::npos || std::filesystem::exists(log.text);
  if (!is_path) return find_data_file("log", "scenarios/logs", log.text).string();
  if (std::filesystem::is_regular_file(log.text)) return log.text;
  throw InputError(log.place, in_quotes(log.text) + " is no file",
                   "give the path of a log or one of the names that 'mapbed list logs' shows");
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

RecordedLog read(const RecordedPlan& plan) {
  if (!plan.description) return load_log(plan.path, plan.options);
  return load_log(find_stored(*plan.description, plan.description->log), plan.options);
}

class RecordedSource : public LogSource {
 public:
  explicit RecordedSource(const RecordedPlan& plan) : plan_(plan), log_(read(plan)) {}

  double recorded_seconds() const override {
    return time_of(log_.measurements.back()) - time_of(log_.measurements.front());
  }
  LogInput input(const SourcePlan& /*plan*/, std::uint64_t /*seed*/) const override {
    LogInput input;
    input.log = log_.measurements;
    input.truth = log_.true_poses;
    if (plan_.description && !plan_.description->relations.file.empty()) {
      input.relations = [this]() -> const MeasuredRelations& { return relations(); };
    }
    return input;
  }

 private:
  const MeasuredRelations& relations() const {
    const std::scoped_lock lock(mutex_);
    if (relations_) return *relations_;
    const LogDescription& description = *plan_.description;
    MeasuredRelations measured;
    measured.relations = load_relations(find_stored(description, description.relations));
    const StoredFile& odometry = description.relations_odometry;
    if (!odometry.file.empty()) {
      measured.odometry = load_trajectory(find_stored(description, odometry));
    }
    return relations_.emplace(std::move(measured));
  }

  const RecordedPlan& plan_;
  RecordedLog log_;
  mutable std::mutex mutex_;
  mutable std::optional<MeasuredRelations> relations_;
};

}  // namespace

SourcePlan plan_recorded(const Settings& settings) {
  const Setting& log = *last_named(settings, "log");
  RecordedPlan recorded{.path = path_of(log)};
  if (recorded.path.ends_with(".yaml")) {
    recorded.description = load_log_description(recorded.path);
    recorded.options = recorded.description->options;
  }
  apply(log_options_of(settings), options_of(recorded.options), "log");
  SourcePlan plan;
  plan.complete_yaml = "log: " + log.text + "\n";
  if (recorded.description) {
    plan.complete_yaml += "sha256: " + recorded.description->log.sha256 + "\n";
  }
  plan.complete_yaml += to_yaml(options_of(recorded.options));
  plan.key = plan.complete_yaml;
  plan.depends_on_seed = false;
  if (recorded.description && !is_here(*recorded.description)) {
    plan.missing =
        fmt::format("the log '{}' is not here ({})", log.text, recorded.description->log.file);
  }
  plan.origin = std::move(recorded);
  return plan;
}

std::unique_ptr<LogSource> open_recorded(const RecordedPlan& plan) {
  return std::make_unique<RecordedSource>(plan);
}

bool tells_truth(const RecordedPlan& plan) {
  return !read(plan).true_poses.empty();
}

}  // namespace mapbed
