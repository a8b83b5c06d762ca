#include "bench/scenario/config_reader.h"

#include "bench/results/plan_yaml.h"
#include "bench/scenario/scenario.h"
#include "core/config/config_node.h"
#include "core/config/settings.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

// All options that held in the runs of a variant, as settings; without those of logs where a run
// has several, for what is set of one would be set of all.
Settings complete_settings(const ConfigNode& variant) {
  Settings all = settings_of(variant.at("experiment"));
  const ConfigNode* source = variant.find(kConfigSource);
  if (source == nullptr || variant.keys().size() > 2) return all;
  const Settings of_log = settings_of(*source);
  all.insert(all.end(), of_log.begin(), of_log.end());
  return all;
}

}  // namespace

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
    scenario.variants.push_back(
        with_own_seeds({.name = name,
                        .settings = settings_of(config.at("compare").at(name)),
                        .complete = complete_settings(config.at("runs").at(name))}));
  }
  return scenario;
}

}  // namespace mapbed
