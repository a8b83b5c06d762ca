#include "bench/scenario/config_text.h"

#include <algorithm>
#include <set>

#include "bench/results/plan_yaml.h"
#include "bench/scenario/config_reader.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/plan.h"
#include "bench/sources/files_record.h"
#include "core/config/settings.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

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
    if (variant.seeds) settings.push_back({"seeds", std::to_string(*variant.seeds), {}});
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
      const std::string name = k == 0 ? kConfigSource : plan.experiment->further_logs[k - 1];
      variant += group(name, planned.sources[k]->complete_yaml);
    }
    variant += group("experiment", planned.experiment.complete_yaml);
    text += group(plan.scenario.variants[i].name, variant);
  }
  return text;
}

}  // namespace

std::string config_text(const ScenarioPlan& plan) {
  return group("scenario", plan_yaml(plan.results)) + given_text(plan.scenario) +
         files_yaml(input_files(plan)) +
         "runs:  # all options of each variant, at the first level of a sweep\n" +
         indented(runs_text(plan), 2);
}

}  // namespace mapbed
