#include "bench/results/plan_yaml.h"

#include <fmt/format.h>

#include "bench/results/flow_text.h"
#include "core/config/config_node.h"
#include "core/config/quantity.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

std::string metric_text(const Metric& metric) {
  return flow_map({{"name", metric.name},
                   {"unit", flow_scalar(unit_symbol(metric.unit))},
                   {"about", flow_scalar(metric.about)}});
}

std::string series_text(const SeriesMetric& series) {
  return flow_map({{"name", series.name},
                   {"unit", flow_scalar(unit_symbol(series.unit))},
                   {"x", flow_scalar(series.x_name)},
                   {"x_unit", flow_scalar(unit_symbol(series.x_unit))},
                   {"about", flow_scalar(series.about)}});
}

// "key:" and a line for each thing; `none` where there are none.
template <class Things, class Text>
std::string block(const std::string& key, const Things& things, const std::string& none,
                  Text&& text_of) {
  if (things.empty()) return none;
  std::string text = key + ":\n";
  for (const auto& thing : things) text += "  - " + text_of(thing) + "\n";
  return text;
}

Unit unit_in(const ConfigNode& node, const char* key) {
  const ConfigNode* unit = node.find(key);
  return unit == nullptr ? Unit::none : unit_of_symbol(unit->text(), unit->place());
}

std::string text_in(const ConfigNode& node, const char* key, const std::string& otherwise = "") {
  const ConfigNode* text = node.find(key);
  return text == nullptr ? otherwise : text->text();
}

Metric metric_of(const ConfigNode& node) {
  return {node.at("name").text(), unit_in(node, "unit"), text_in(node, "about")};
}

SeriesMetric series_of(const ConfigNode& node) {
  return {node.at("name").text(), unit_in(node, "unit"), node.at("x").text(),
          unit_in(node, "x_unit"), text_in(node, "about")};
}

void read_words(const ConfigNode& scenario, Results& plan) {
  plan.id = scenario.at("id").text();
  plan.about = text_in(scenario, "about");
  plan.thesis = text_in(scenario, "thesis");
  plan.experiment = text_in(scenario, "experiment", "slam");
  if (const ConfigNode* quick = scenario.find("quick")) plan.quick = quick->flag();
  if (const ConfigNode* judges = scenario.find("judges")) plan.judges = judges->flag();
  if (const ConfigNode* seed = scenario.find("seed")) plan.seed = seed->unsigned_number();
  if (const ConfigNode* seeds = scenario.find("seeds")) plan.seeds = seeds->whole_number();
}

void read_claims(const ConfigNode& claims, Results& plan) {
  for (const ConfigNode& claim : claims.items()) {
    if (claim.kind() == ConfigNode::Kind::map) plan.claims.push_back(claim_of(claim));
  }
}

}  // namespace

std::string design_yaml(const Results& plan) {
  std::string text = "experiment: " + yaml_scalar(plan.experiment) + "\n";
  text += fmt::format("quick: {}\n", plan.quick);
  if (plan.quick) text += fmt::format("judges: {}\n", plan.judges);
  text += fmt::format("seed: {}\nseeds: {}\n", plan.seed, plan.seeds);
  text += plan.axes.empty() ? "sweep: {}\n" : "sweep:\n";
  for (const SweepAxis& axis : plan.axes) {
    const std::string values = axis.sets.empty() ? flow_list(axis.texts) : names_text(axis);
    text += "  " + yaml_scalar(axis.path) + ": " + values + "\n";
  }
  text += "variants: " + flow_list(plan.variants) + "\n";
  text += block("metrics", plan.metrics, "metrics: []\n", metric_text);
  text += block("series", plan.series_metrics, "", series_text);
  if (!plan.skipped.empty()) text += "skipped: " + flow_list(plan.skipped) + "\n";
  return text;
}

std::string plan_yaml(const Results& plan) {
  std::string text = "id: " + yaml_scalar(plan.id) + "\n";
  text += "about: " + yaml_scalar(plan.about) + "\n";
  text += "thesis: " + yaml_scalar(plan.thesis) + "\n";
  text += design_yaml(plan);
  text += block("plots", plan.plots, "plots: []\n", plot_text);
  text += block("claims", plan.claims, "claims: []\n", claim_text);
  return text;
}

Results plan_in(const ConfigNode& config) {
  const ConfigNode& scenario = config.at("scenario");
  Results plan;
  read_words(scenario, plan);
  if (const ConfigNode* sweep = scenario.find("sweep")) {
    for (const std::string& path : sweep->keys()) {
      const ConfigNode& values = sweep->at(path);
      const bool has_names = values.kind() == ConfigNode::Kind::map;
      plan.axes.push_back(has_names ? named_axis_of(path, values) : axis_of(path, values.texts()));
      plan.axes.back().place = values.place();
    }
  }
  plan.levels = levels_of(plan.axes);
  plan.variants = scenario.at("variants").texts();
  for (const ConfigNode& metric : scenario.at("metrics").items()) {
    plan.metrics.push_back(metric_of(metric));
  }
  if (const ConfigNode* series = scenario.find("series")) {
    for (const ConfigNode& one : series->items()) plan.series_metrics.push_back(series_of(one));
  }
  if (const ConfigNode* skipped = scenario.find("skipped")) plan.skipped = skipped->texts();
  if (const ConfigNode* plots = scenario.find("plots")) {
    for (const ConfigNode& plot : plots->items()) plan.plots.push_back(plot_of(plot));
  }
  if (const ConfigNode* claims = scenario.find("claims")) read_claims(*claims, plan);
  return plan;
}

Results load_plan(const std::string& config_path) {
  return plan_in(load_config(config_path));
}

}  // namespace mapbed
