#include "bench/scenario/plan.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "bench/results/claim_check.h"
#include "bench/results/plot_spec.h"
#include "bench/scenario/config_text.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

constexpr double kMostRuns = 100'000;

void check_count(const Scenario& scenario) {
  double runs = static_cast<double>(scenario.seeds) * static_cast<double>(scenario.variants.size());
  for (const SweepAxis& axis : scenario.axes) runs *= static_cast<double>(axis.texts.size());
  if (runs <= kMostRuns) return;
  throw InputError(
      {scenario.path}, fmt::format("this makes {:.0f} runs", runs),
      fmt::format("at most {:.0f} are run; sweep less or take fewer seeds", kMostRuns));
}

std::vector<std::string> names_of(const std::vector<Metric>& metrics) {
  std::vector<std::string> names;
  for (const Metric& metric : metrics) names.push_back(metric.name);
  return names;
}

std::vector<Metric> chosen_metrics(const Scenario& scenario, const Experiment& experiment) {
  std::vector<Metric> chosen;
  for (const std::string& name : scenario.metrics) {
    const auto found = std::find_if(experiment.metrics.begin(), experiment.metrics.end(),
                                    [&](const Metric& metric) { return metric.name == name; });
    if (found == experiment.metrics.end()) {
      throw InputError(scenario.metrics_place,
                       "unknown metric '" + name + "' of experiment " + experiment.name,
                       suggestion(name, names_of(experiment.metrics)));
    }
    chosen.push_back(*found);
  }
  if (chosen.empty()) {
    throw InputError(
        {scenario.path}, "nothing is measured",
        "name one or more under 'metrics'; " + suggestion("", names_of(experiment.metrics)));
  }
  return chosen;
}

Results empty_results(const Scenario& scenario, const Experiment& experiment) {
  Results results;
  results.id = scenario.id;
  results.about = scenario.about;
  results.thesis = scenario.thesis;
  results.experiment = scenario.experiment;
  results.quick = scenario.quick;
  results.seed = scenario.seed;
  results.seeds = scenario.seeds;
  results.axes = scenario.axes;
  results.levels = levels_of(scenario.axes);
  for (const Variant& variant : scenario.variants) results.variants.push_back(variant.name);
  results.metrics = chosen_metrics(scenario, experiment);
  results.plots = scenario.plots;
  results.claims = scenario.claims;
  return results;
}

// A line for each log that is not here.
std::vector<std::string> skipped_in(const ScenarioPlan& plan) {
  std::map<std::string, int> runs_by_reason;
  for (const PlannedRuns& planned : plan.planned) {
    if (planned.source.missing.empty()) continue;
    runs_by_reason[planned.source.missing] += plan.scenario.seeds;
  }
  std::vector<std::string> lines;
  for (const auto& [reason, runs] : runs_by_reason) {
    lines.push_back(fmt::format("{}: {} runs skipped", reason, runs));
  }
  if (!lines.empty() && plan.runs_to_do().empty()) {
    throw InputError(
        {plan.scenario.path}, runs_by_reason.begin()->first,
        "set MAPBED_DATA to the folder that holds the logs; 'mapbed describe' of a log "
        "says how to get it");
  }
  return lines;
}

// A key of the form that is misspelt ends among the options of the experiment.
void check_keys(const Scenario& scenario, const Experiment& experiment) {
  static const std::vector<std::string> kForm{
      "about", "thesis", "base",  "experiment", "sweep", "compare", "seeds", "seed",   "metrics",
      "plots", "claims", "quick", "set",        "world", "robot",   "path",  "people", "log"};
  for (const Setting& setting : divided(scenario.settings).experiment) {
    if (setting.path.find('.') != std::string::npos) continue;
    const std::string meant = nearest(setting.path, kForm);
    if (meant.empty()) continue;
    try {
      (void)experiment.complete_yaml({setting});
    } catch (const InputError&) {
      throw InputError(setting.place, "unknown key " + in_quotes(setting.path),
                       "did you mean " + in_quotes(meant) + "?");
    }
  }
}

}  // namespace

int ScenarioPlan::runs() const {
  return scenario.seeds * static_cast<int>(planned.size());
}

std::vector<int> ScenarioPlan::runs_to_do() const {
  std::vector<int> numbers;
  for (int run = 0; run < runs(); ++run) {
    if (planned_of(row(run)).source.missing.empty()) numbers.push_back(run);
  }
  return numbers;
}

RunRow ScenarioPlan::row(int run) const {
  const int variants = static_cast<int>(scenario.variants.size());
  const int of_a_seed = static_cast<int>(planned.size());
  RunRow row{.run = run, .level = run % of_a_seed / variants, .variant = run % variants};
  row.seed = scenario.seed + static_cast<std::uint64_t>(run / of_a_seed);
  return row;
}

const PlannedRuns& ScenarioPlan::planned_of(const RunRow& row) const {
  return planned[static_cast<std::size_t>(row.level) * scenario.variants.size() +
                 static_cast<std::size_t>(row.variant)];
}

PlannedRuns planned_runs(const Scenario& scenario, const Experiment& experiment, const Level& level,
                         const Variant& variant, SimulationParts& parts) {
  PlannedRuns planned{.settings = divided(settings_of(scenario, level, variant))};
  planned.experiment_yaml = experiment.complete_yaml(planned.settings.experiment);
  if (experiment.needs_log) {
    planned.source = plan_source(planned.settings.source, parts);
  } else if (!planned.settings.source.empty()) {
    const Setting& setting = planned.settings.source.front();
    throw InputError(setting.place,
                     in_quotes(setting.path) + " says nothing to the experiment " +
                         experiment.name + ", which needs no log",
                     "take it out");
  }
  return planned;
}

ScenarioPlan make_plan(Scenario scenario) {
  check_count(scenario);
  ScenarioPlan plan{.scenario = std::move(scenario)};
  plan.experiment = &experiment_by_name(plan.scenario.experiment, plan.scenario.experiment_place);
  plan.results = empty_results(plan.scenario, *plan.experiment);
  for (const Claim& claim : plan.results.claims) check_claim(claim, plan.results);
  for (const PlotSpec& plot : plan.results.plots) check_plot(plot, plan.results);
  check_keys(plan.scenario, *plan.experiment);
  SimulationParts parts;
  for (const Level& level : plan.results.levels) {
    for (const Variant& variant : plan.scenario.variants) {
      plan.planned.push_back(planned_runs(plan.scenario, *plan.experiment, level, variant, parts));
    }
  }
  plan.results.skipped = skipped_in(plan);
  plan.results.config_yaml = config_text(plan);
  return plan;
}

}  // namespace mapbed
