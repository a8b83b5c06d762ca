#include "bench/scenario/config_text.h"

#include <algorithm>
#include <set>

#include "bench/results/plan_yaml.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/plan.h"
#include "bench/sources/files_record.h"
#include "core/config/config_node.h"
#include "core/config/settings.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

constexpr const char* kSource = "source";  // the scenario's own log, among the further ones

// A line for each, but for those that a later one of the same path overrides.
std::string settings_text(const Settings& settings) {
  std::set<std::string> later;
  std::vector<std::string> lines;
  for (auto setting = settings.rbegin(); setting != settings.rend(); ++setting) {
    if (!later.insert(setting->path).second) continue;
    lines.push_back(yaml_scalar(setting->path) + ": " + yaml_scalar(setting->text) + "\n");
  }
  std::string text;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) text += *line;
  return text;
}

// "key: {}" where there is nothing in it.
std::string group(const std::string& key, const std::string& content) {
  return yaml_scalar(key) + (content.empty() ? ": {}\n" : ":\n" + indented(content, 2));
}

std::string given_text(const Scenario& scenario) {
  std::string variants;
  for (const Variant& variant : scenario.variants) {
    Settings settings = variant.settings;
    settings.insert(settings.end(), scenario.overrides.begin(), scenario.overrides.end());
    variants += group(variant.name, settings_text(settings));
  }
  return group("settings", settings_text(scenario.settings)) + group("compare", variants);
}

std::string runs_text(const ScenarioPlan& plan) {
  std::string text;
  for (std::size_t i = 0; i < plan.scenario.variants.size(); ++i) {
    const PlannedRuns& planned = plan.planned[i];
    std::string variant;
    for (std::size_t k = 0; k < planned.sources.size(); ++k) {
      const std::string name = k == 0 ? kSource : plan.experiment->further_logs[k - 1];
      variant += group(name, planned.sources[k]->complete_yaml);
    }
    variant += group("experiment", planned.experiment.complete_yaml);
    text += group(plan.scenario.variants[i].name, variant);
  }
  return text;
}

// All options that held in the runs of a variant, as settings; without those of logs where a run
// has several, for what is set of one would be set of all.
Settings complete_settings(const ConfigNode& variant) {
  Settings all = settings_of(variant.at("experiment"));
  const ConfigNode* source = variant.find(kSource);
  if (source == nullptr || variant.keys().size() > 2) return all;
  const Settings of_log = settings_of(*source);
  all.insert(all.end(), of_log.begin(), of_log.end());
  return all;
}

}  // namespace

std::string config_text(const ScenarioPlan& plan) {
  return group("scenario", plan_yaml(plan.results)) + given_text(plan.scenario) +
         files_yaml(input_files(plan)) +
         "runs:  # all options of each variant, at the first level of a sweep\n" +
         indented(runs_text(plan), 2);
}

bool is_config(const ConfigNode& file) {
  return file.find("scenario") != nullptr && file.find("runs") != nullptr;
}

Scenario scenario_in(const ConfigNode& config) {
  if (config.find("compare") == nullptr) {
    throw InputError({config.place().file}, "was written by an older program, which cannot be run",
                     "run the scenario that it is of");
  }
  const Results plan = plan_in(config);
  Scenario scenario{.id = plan.id,
                    .path = config.place().file,
                    .about = plan.about,
                    .thesis = plan.thesis,
                    .experiment = plan.experiment,
                    .experiment_place = config.at("scenario").place(),
                    .settings = settings_of(config.at("settings")),
                    .axes = plan.axes,
                    .seeds = plan.seeds,
                    .seed = plan.seed,
                    .metrics_place = config.at("scenario").at("metrics").place(),
                    .plots = plan.plots,
                    .claims = plan.claims,
                    .quick = plan.quick,
                    .judges = plan.judges};
  for (const Metric& metric : plan.metrics) scenario.metrics.push_back(metric.name);
  for (const SeriesMetric& series : plan.series_metrics) scenario.metrics.push_back(series.name);
  for (const std::string& name : config.at("compare").keys()) {
    scenario.variants.push_back({.name = name,
                                 .settings = settings_of(config.at("compare").at(name)),
                                 .complete = complete_settings(config.at("runs").at(name))});
  }
  return scenario;
}

}  // namespace mapbed
