#include "bench/sources/recorded_source.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <mutex>

#include <fmt/format.h>

#include "algorithms/input/geometry_check.h"
#include "bench/metrics/pairs.h"
#include "bench/sources/chosen_log.h"
#include "bench/sources/source_settings.h"
#include "core/config/yaml_scalar.h"
#include "core/data_path.h"
#include "core/geometry/tum_file.h"
#include "core/input_error.h"
#include "core/log/log_description.h"
#include "core/log/log_file.h"

namespace mapbed {
namespace {

// "drive" is a name, though a folder may be called so.
void refuse_path_that_looks_like_a_name(const Setting& log) {
  const std::vector<std::string> names = data_names("scenarios/logs");
  if (std::find(names.begin(), names.end(), log.text) != names.end()) return;
  const std::filesystem::path folder(log.place.line > 0 ? log.place.file : "");
  if (!std::filesystem::exists(folder.parent_path() / log.text)) return;
  throw InputError(log.place, in_quotes(log.text) + " is no name that 'mapbed list logs' shows",
                   "write ./" + log.text + " for the file or folder that is called so");
}

// The log's own path, or that of its description.
std::string path_of(const Setting& log) {
  const bool is_path = log.text.find('/') != std::string::npos;
  if (!is_path) refuse_path_that_looks_like_a_name(log);
  const FilesCalledSo files{log.place, endings_of_logs()};
  if (!is_path) return find_data_file("log", "scenarios/logs", log.text, files).string();
  if (std::filesystem::exists(log.text)) return log.text;
  throw InputError(log.place, in_quotes(log.text) + " is neither a file nor a folder",
                   "give the path of a log or one of the names that 'mapbed list logs' shows");
}

// Without "log." in front.
Settings log_options_of(const Settings& settings) {
  Settings options;
  for (Setting setting : settings) {
    if (setting.path == "log" || setting.path.starts_with("faults.")) continue;
    if (!setting.path.starts_with("log.")) {
      throw InputError(setting.place, in_quotes(setting.path) + " says nothing to a recorded log",
                       "take it out, or take 'log' out to simulate one");
    }
    setting.path.erase(0, 4);
    options.push_back(std::move(setting));
  }
  return options;
}

Settings faults_of(const Settings& settings) {
  Settings faults;
  std::copy_if(settings.begin(), settings.end(), std::back_inserter(faults),
               [](const Setting& setting) { return setting.path.starts_with("faults."); });
  return faults;
}

RecordedLog read(const RecordedPlan& plan, const GoesOn& goes_on = {}) {
  for (const InputFile& file : plan.log) check_unchanged(file);
  RecordedLog log = load_log(plan.path, plan.options, goes_on);
  if (!has_scans(log.measurements)) throw InputError({plan.path}, "holds no laser scan");
  (void)choose_geometry(log);
  return log;
}

class RecordedSource : public LogSource {
 public:
  RecordedSource(const RecordedPlan& plan, const GoesOn& goes_on)
      : plan_(plan), log_(read(plan, goes_on)) {}

  double recorded_seconds() const override {
    return time_of(log_.measurements.back()) - time_of(log_.measurements.front());
  }

 private:
  LogInput clean_input(const SourcePlan& /*plan*/, std::uint64_t /*seed*/) const override {
    LogInput input;
    input.log = log_.measurements;
    input.truth = log_.true_poses;
    if (plan_.relations) {
      input.relations = [this]() -> const MeasuredRelations& { return relations(); };
    }
    if (plan_.reference) {
      input.pairs = [this]() -> const std::vector<Relation>& { return pairs(); };
    }
    return input;
  }

  const MeasuredRelations& relations() const {
    const std::scoped_lock lock(mutex_);
    if (relations_) return *relations_;
    MeasuredRelations measured;
    check_unchanged(*plan_.relations);
    measured.relations = load_relations(plan_.relations->path);
    if (plan_.relations_odometry) {
      check_unchanged(*plan_.relations_odometry);
      measured.odometry = load_trajectory(plan_.relations_odometry->path);
    }
    return relations_.emplace(std::move(measured));
  }

  const std::vector<Relation>& pairs() const {
    const std::scoped_lock lock(mutex_);
    if (pairs_) return *pairs_;
    check_unchanged(*plan_.reference);
    return pairs_.emplace(pairs_of(load_trajectory(plan_.reference->path)));
  }

  const RecordedPlan& plan_;
  RecordedLog log_;
  mutable std::mutex mutex_;
  mutable std::optional<MeasuredRelations> relations_;
  mutable std::optional<std::vector<Relation>> pairs_;
};

// What is stored with the log; none where the description names no such file.
std::optional<InputFile> found(const LogDescription& description, const StoredFile& stored,
                               HashedFiles& files) {
  if (stored.file.empty()) return std::nullopt;
  return find_stored(description, stored, files);
}

RecordedPlan described(const LogDescription& description, HashedFiles& files) {
  const InputFile log = find_stored(description, description.log, files);
  return {.path = log.path,
          .log = {log},
          .options = description.options,
          .relations = found(description, description.relations, files),
          .relations_odometry = found(description, description.relations_odometry, files),
          .reference = found(description, description.reference, files)};
}

InputFiles files_of(const RecordedPlan& plan) {
  InputFiles files = plan.log;
  for (const auto& file : {plan.relations, plan.relations_odometry, plan.reference}) {
    if (file) merge({*file}, files);
  }
  return files;
}

}  // namespace

SourcePlan plan_recorded(const Settings& settings, HashedFiles& files) {
  const Setting& log = *last_named(settings, "log");
  const std::string path = path_of(log);
  RecordedPlan recorded;
  SourcePlan plan{.depends_on_seed = false};
  if (path.ends_with(".yaml")) {
    plan.files = {files.at(path)};
    const LogDescription description = load_log_description(path);
    recorded.options = description.options;
    if (is_here(description)) {
      recorded = described(description, files);
    } else {
      const std::string fetch =
          can_be_fetched(description) ? "; 'mapbed fetch " + log.text + "' gets it" : "";
      plan.missing =
          fmt::format("the log '{}' is not here ({}{})", log.text, description.log.file, fetch);
    }
  } else {
    recorded.path = path;
    for (const std::string& file : files_of_log(path)) recorded.log.push_back(files.at(file));
  }
  apply(log_options_of(settings), options_of(recorded.options), "log");
  plan.complete_yaml =
      "log: " + yaml_scalar(log.text) + "\n" + dotted("log", to_yaml(options_of(recorded.options)));
  plan.key = plan.clean_yaml = plan.complete_yaml;
  plan.faults = plan_faults(faults_of(settings));
  plan.complete_yaml += plan.faults.complete_yaml;
  if (plan.missing.empty()) merge(files_of(recorded), plan.files);
  plan.origin = std::move(recorded);
  return plan;
}

std::unique_ptr<LogSource> open_recorded(const RecordedPlan& plan, const GoesOn& goes_on) {
  return std::make_unique<RecordedSource>(plan, goes_on);
}

bool tells_truth(const RecordedPlan& plan) {
  return !read(plan).true_poses.empty();
}

}  // namespace mapbed
