#include "bench/scenario/scenario_log.h"

#include <algorithm>

#include "bench/scenario/plan.h"
#include "bench/sources/source_settings.h"
#include "core/config/suggestion.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

std::vector<Variant> chosen_variants(const Scenario& scenario, const std::string& name) {
  if (name.empty()) return scenario.variants;
  std::vector<std::string> names;
  for (const Variant& variant : scenario.variants) {
    if (variant.name == name) return {variant};
    names.push_back(variant.name);
  }
  throw InputError({scenario.path}, in_quotes(name) + " is not compared in this scenario",
                   suggestion(name, names));
}

// How the first log that differs from the first one comes about, and the way to choose.
[[noreturn]] void refuse_several(const Scenario& scenario, const std::vector<Variant>& variants,
                                 const Level& level, const Variant& variant) {
  if (variant.name != variants.front().name) {
    throw InputError({scenario.path}, "its variants have different logs",
                     "choose one, as in --variant " + in_quotes(variant.name));
  }
  for (std::size_t i = 0; i < scenario.axes.size(); ++i) {
    const SweepAxis& axis = scenario.axes[i];
    const auto is_of_log_at = [&axis](int choice) {
      return !divided(settings_at(axis, choice)).source.empty();
    };
    bool is_of_log = false;
    for (std::size_t k = 0; k < axis.texts.size(); ++k) {
      is_of_log = is_of_log || is_of_log_at(static_cast<int>(k));
    }
    if (!is_of_log || axis.texts.size() == 1) continue;
    const std::string& value = axis.texts[static_cast<std::size_t>(level.choice[i])];
    throw InputError({scenario.path}, "it sweeps '" + axis.path + "', so it has several logs",
                     "choose one, as in --set " + in_quotes(axis.path + "=" + value));
  }
  throw InputError({scenario.path}, "it has several logs", "choose a level with --set");
}

}  // namespace

PreparedSimulation simulation_in(const Scenario& scenario, const std::string& variant) {
  const Experiment& experiment = experiment_by_name(scenario.experiment, scenario.experiment_place);
  if (experiment.needs == Experiment::Needs::nothing) {
    throw InputError({scenario.path}, "its experiment, " + experiment.name + ", needs no log",
                     "simulate a scenario that has a world and a robot");
  }
  const std::vector<Variant> variants = chosen_variants(scenario, variant);
  PlannedSources sources(experiment);
  std::shared_ptr<const SourcePlan> chosen;
  for (const Variant& of : variants) {
    for (const Level& level : levels_of(scenario.axes)) {
      const auto log = planned_runs(scenario, experiment, level, of, sources).sources.front();
      if (!log->is_simulated()) {
        throw InputError({scenario.path}, "its log is a recorded one", "'mapbed map' works on it");
      }
      if (!chosen) chosen = log;
      if (log->complete_yaml != chosen->complete_yaml) {
        refuse_several(scenario, variants, level, of);
      }
    }
  }
  return std::get<PreparedSimulation>(chosen->origin);
}

}  // namespace mapbed
