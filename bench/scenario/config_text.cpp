#include "bench/scenario/config_text.h"

#include <sstream>

#include <fmt/format.h>

#include "bench/results/flow_text.h"
#include "bench/results/plot_spec.h"
#include "bench/scenario/plan.h"
#include "core/config/config_node.h"
#include "core/config/quantity.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

std::string indented(const std::string& yaml, int spaces) {
  std::istringstream lines(yaml);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    result += std::string(static_cast<std::size_t>(spaces), ' ') + line + "\n";
  }
  return result;
}

std::string metric_text(const Metric& metric) {
  // The unit by its SI symbol: "1 m" without the number.
  const std::string one =
      metric.unit == Unit::none ? "" : quantity_text(1.0, metric.unit).substr(2);
  return flow_map(
      {{"name", metric.name}, {"unit", flow_scalar(one)}, {"about", flow_scalar(metric.about)}});
}

// What the runs are: nothing else in the scenario changes their results.
std::string design_text(const ScenarioPlan& plan) {
  const Scenario& scenario = plan.scenario;
  std::string text = "experiment: " + yaml_scalar(scenario.experiment) + "\n";
  text += fmt::format("quick: {}\nseed: {}\nseeds: {}\n", scenario.quick, scenario.seed,
                      scenario.seeds);
  text += scenario.axes.empty() ? "sweep: {}\n" : "sweep:\n";
  for (const SweepAxis& axis : scenario.axes) {
    text += "  " + yaml_scalar(axis.path) + ": " + flow_list(axis.texts) + "\n";
  }
  text += "variants: " + flow_list(plan.results.variants) + "\n";
  text += "metrics:\n";
  for (const Metric& metric : plan.results.metrics) text += "  - " + metric_text(metric) + "\n";
  if (!plan.results.skipped.empty()) {
    text += "skipped: " + flow_list(plan.results.skipped) + "\n";
  }
  return text;
}

std::string scenario_text(const ScenarioPlan& plan) {
  const Scenario& scenario = plan.scenario;
  std::string text = "id: " + yaml_scalar(scenario.id) + "\n";
  text += "about: " + yaml_scalar(scenario.about) + "\n";
  text += "thesis: " + yaml_scalar(scenario.thesis) + "\n";
  text += design_text(plan);
  text += plan.results.plots.empty() ? "plots: []\n" : "plots:\n";
  for (const PlotSpec& plot : plan.results.plots) text += "  - " + plot_text(plot) + "\n";
  text += scenario.claims.empty() ? "claims: []\n" : "claims:\n";
  for (const Claim& claim : scenario.claims) {
    text += "  - " + yaml_scalar(text_of(claim, plan.results)) + "\n";
  }
  return text;
}

std::string runs_text(const ScenarioPlan& plan) {
  std::string text;
  for (std::size_t i = 0; i < plan.scenario.variants.size(); ++i) {
    const PlannedRuns& planned = plan.planned[i];
    text += yaml_scalar(plan.scenario.variants[i].name) + ":\n";
    if (!planned.source.complete_yaml.empty()) {
      text += "  source:\n" + indented(planned.source.complete_yaml, 4);
    }
    text += "  experiment:\n" + indented(planned.experiment_yaml, 4);
  }
  return text;
}

Unit unit_of(const std::string& symbol, const SourceLocation& place) {
  for (int i = 0; i <= static_cast<int>(Unit::newton); ++i) {
    const auto unit = static_cast<Unit>(i);
    if (unit != Unit::none && quantity_text(1.0, unit).substr(2) == symbol) return unit;
  }
  throw InputError(place, in_quotes(symbol) + " is no unit");
}

Metric metric_of(const ConfigNode& node) {
  Metric metric{.name = node.at("name").text()};
  if (const ConfigNode* unit = node.find("unit"))
    metric.unit = unit_of(unit->text(), unit->place());
  if (const ConfigNode* about = node.find("about")) metric.about = about->text();
  return metric;
}

}  // namespace

std::string identity_text(const ScenarioPlan& plan) {
  return design_text(plan) + runs_text(plan);
}

std::string config_text(const ScenarioPlan& plan) {
  return "scenario:\n" + indented(scenario_text(plan), 2) +
         "runs:  # all options of each variant, at the first level of a sweep\n" +
         indented(runs_text(plan), 2);
}

Results load_planned(const std::string& config_path) {
  const ConfigNode file = load_config(config_path);
  const ConfigNode& scenario = file.at("scenario");
  Results results;
  results.id = scenario.at("id").text();
  results.about = scenario.at("about").text();
  results.thesis = scenario.at("thesis").text();
  results.quick = scenario.at("quick").flag();
  const ConfigNode& sweep = scenario.at("sweep");
  for (const std::string& path : sweep.keys()) {
    results.axes.push_back(axis_of(path, sweep.at(path).texts()));
  }
  results.levels = levels_of(results.axes);
  results.variants = scenario.at("variants").texts();
  for (const ConfigNode& metric : scenario.at("metrics").items()) {
    results.metrics.push_back(metric_of(metric));
  }
  if (const ConfigNode* skipped = scenario.find("skipped")) results.skipped = skipped->texts();
  for (const ConfigNode& plot : scenario.at("plots").items()) {
    results.plots.push_back(plot_of(plot));
  }
  return results;
}

}  // namespace mapbed
