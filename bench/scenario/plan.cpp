#include "bench/scenario/plan.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "bench/results/claim_check.h"
#include "bench/results/plot_spec.h"
#include "bench/scenario/config_text.h"
#include "bench/sources/source_settings.h"
#include "core/config/suggestion.h"
#include "core/config/yaml_limit.h"
#include "core/file/utf8.h"
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

// Of everything that it measures.
std::vector<std::string> names_of(const Experiment& experiment) {
  std::vector<std::string> names;
  for (const Metric& metric : experiment.metrics) names.push_back(metric.name);
  for (const SeriesMetric& series : experiment.series) names.push_back(series.name);
  return names;
}

// Appends the one of this name to the chosen ones.
template <class Described>
bool choose(const std::string& name, const std::vector<Described>& all,
            std::vector<Described>& chosen) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Described& metric) { return metric.name == name; });
  if (found == all.end()) return false;
  chosen.push_back(*found);
  return true;
}

// Those that the scenario names under 'metrics': numbers and series.
void choose_metrics(const Scenario& scenario, const Experiment& experiment, Results& results) {
  for (const std::string& name : scenario.metrics) {
    if (choose(name, experiment.metrics, results.metrics)) continue;
    if (choose(name, experiment.series, results.series_metrics)) continue;
    throw InputError(scenario.metrics_place,
                     "unknown metric '" + name + "' of experiment " + experiment.name,
                     suggestion(name, names_of(experiment)));
  }
  if (scenario.metrics.empty()) {
    throw InputError({scenario.path}, "nothing is measured",
                     "name one or more under 'metrics'; " + suggestion("", names_of(experiment)));
  }
}

Results empty_results(const Scenario& scenario, const Experiment& experiment) {
  Results results;
  results.id = scenario.id;
  results.about = scenario.about;
  results.thesis = scenario.thesis;
  results.experiment = scenario.experiment;
  results.quick = scenario.quick;
  results.judges = scenario.judges;
  results.seed = scenario.seed;
  results.seeds = scenario.seeds;
  results.axes = scenario.axes;
  results.levels = levels_of(scenario.axes);
  for (const Variant& variant : scenario.variants) results.variants.push_back(variant.name);
  choose_metrics(scenario, experiment, results);
  results.plots = scenario.plots;
  results.claims = scenario.claims;
  return results;
}

// A line for each log that is not here.
std::vector<std::string> skipped_in(const ScenarioPlan& plan) {
  std::map<std::string, int> runs_by_reason;
  for (const PlannedRuns& planned : plan.planned) {
    const std::string missing = planned.missing();
    const auto variant = (&planned - plan.planned.data()) %
                         static_cast<std::ptrdiff_t>(plan.scenario.variants.size());
    if (!missing.empty()) runs_by_reason[missing] += plan.seeds_of(static_cast<int>(variant));
  }
  std::vector<std::string> lines;
  for (const auto& [reason, runs] : runs_by_reason) {
    lines.push_back(fmt::format("{}: {} runs skipped", reason, runs));
  }
  if (!lines.empty() && plan.runs_to_do().empty()) {
    throw InputError(
        {plan.scenario.path}, runs_by_reason.begin()->first,
        "set MAPBED_DATA to the folder that holds the logs; 'mapbed fetch' of a log gets it, or "
        "says how");
  }
  return lines;
}

// A key of the form that is misspelt ends among the options of the experiment.
void check_keys(const Scenario& scenario, const Experiment& experiment) {
  static const std::vector<std::string> kForm{"about",   "thesis", "base",   "experiment", "sweep",
                                              "compare", "seeds",  "seed",   "metrics",    "plots",
                                              "claims",  "quick",  "set",    "world",      "robot",
                                              "path",    "driver", "people", "log"};
  for (const Setting& setting : divided(scenario.settings, experiment.further_logs).experiment) {
    if (setting.path.find('.') != std::string::npos) continue;
    const std::string meant = nearest(setting.path, kForm);
    if (meant.empty()) continue;
    try {
      (void)experiment.configure({setting});
    } catch (const InputError&) {
      throw InputError(setting.place, "unknown key " + in_quotes(setting.path),
                       "did you mean " + in_quotes(meant) + "?");
    }
  }
}

// An experiment without a log has no settings of one.
void refuse_source(const Experiment& experiment, const Settings& source) {
  if (source.empty()) return;
  throw InputError(source.front().place,
                   in_quotes(source.front().path) + " says nothing to the experiment " +
                       experiment.name + ", which needs no log",
                   "take it out");
}

// A source that cannot give what the experiment needs. Only recorded logs lack something.
void check_offer(const Experiment& experiment, const SourcePlan& source, const Settings& settings) {
  if (source.is_simulated() || !source.missing.empty()) return;
  const bool lacks_world = experiment.needs == Experiment::Needs::world;
  const bool lacks_truth = experiment.needs == Experiment::Needs::truth && !has_truth(source);
  if (!lacks_world && !lacks_truth) return;
  const Setting* log = last_named(settings, "log");
  throw InputError(
      log == nullptr ? SourceLocation{} : log->place,
      fmt::format("the experiment {} needs {}, and this recorded log has no {}", experiment.name,
                  text_of(experiment.needs), lacks_world ? "world" : "true path"),
      "give 'world' and 'robot' instead, for a simulated log");
}

// What is written shall be read again: a report and a later start do.
void check_config(const ScenarioPlan& plan) {
  if (!is_utf8(plan.results.config_yaml)) {
    throw InputError({escaped_utf8(plan.scenario.path)},
                     "its name, or that of a file that it needs, is not UTF-8", "rename the file");
  }
  const std::size_t bytes = plan.results.config_yaml.size();
  if (bytes <= kLargestYaml) return;
  throw InputError(
      {plan.scenario.path},
      fmt::format("the complete configuration of {} variants has {} MB, too many to be "
                  "read again",
                  plan.scenario.variants.size(), bytes >> 20),
      "compare fewer variants, or sweep an option instead");
}

}  // namespace

int ScenarioPlan::runs() const {
  return scenario.seeds * static_cast<int>(planned.size());
}

std::vector<int> ScenarioPlan::runs_to_do() const {
  std::vector<int> numbers;
  for (int run = 0; run < runs(); ++run) {
    const RunRow of = row(run);
    const auto seeds = static_cast<std::uint64_t>(seeds_of(of.variant));
    if (of.seed - scenario.seed >= seeds) continue;
    if (planned_of(of).missing().empty()) numbers.push_back(run);
  }
  return numbers;
}

int ScenarioPlan::seeds_of(int variant) const {
  const Variant& of = scenario.variants[static_cast<std::size_t>(variant)];
  return std::min(scenario.seeds, of.seeds.value_or(scenario.seeds));
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

std::string PlannedRuns::missing() const {
  if (!experiment.missing.empty()) return experiment.missing;
  for (const auto& source : sources) {
    if (!source->missing.empty()) return source->missing;
  }
  return {};
}

std::shared_ptr<const SourcePlan> PlannedSources::planned(const Settings& settings) {
  std::string texts;
  for (const Setting& setting : settings) texts += setting.path + "=" + setting.text + "\n";
  std::shared_ptr<const SourcePlan>& plan = by_settings_[texts];
  if (!plan) {
    plan = std::make_shared<const SourcePlan>(plan_source(settings, parts_));
    check_offer(experiment_, *plan, settings);
  }
  return plan;
}

PlannedRuns planned_runs(const Scenario& scenario, const Experiment& experiment, const Level& level,
                         const Variant& variant, PlannedSources& sources) {
  const DividedSettings settings =
      divided(settings_of(scenario, level, variant), experiment.further_logs);
  PlannedRuns planned{.experiment = experiment.configure(settings.experiment)};
  if (experiment.needs == Experiment::Needs::nothing) {
    refuse_source(experiment, settings.source);
    return planned;
  }
  planned.sources.push_back(sources.planned(settings.source));
  for (const std::string& name : experiment.further_logs) {
    planned.sources.push_back(sources.planned(settings.further.at(name)));
  }
  return planned;
}

ScenarioPlan make_plan(Scenario scenario) {
  const Experiment& experiment = experiment_by_name(scenario.experiment, scenario.experiment_place);
  return make_plan(std::move(scenario), experiment);
}

ScenarioPlan make_plan(Scenario scenario, const Experiment& experiment) {
  check_count(scenario);
  ScenarioPlan plan{.scenario = std::move(scenario), .experiment = &experiment};
  plan.results = empty_results(plan.scenario, *plan.experiment);
  for (const Claim& claim : plan.results.claims) check_claim(claim, plan.results);
  for (const PlotSpec& plot : plan.results.plots) check_plot(plot, plan.results);
  check_keys(plan.scenario, *plan.experiment);
  PlannedSources sources(experiment);
  for (const Level& level : plan.results.levels) {
    for (const Variant& variant : plan.scenario.variants) {
      plan.planned.push_back(
          planned_runs(plan.scenario, *plan.experiment, level, variant, sources));
    }
  }
  plan.results.skipped = skipped_in(plan);
  plan.results.config_yaml = config_text(plan);
  check_config(plan);
  return plan;
}

}  // namespace mapbed
