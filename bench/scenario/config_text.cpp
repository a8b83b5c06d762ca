#include "bench/scenario/config_text.h"

#include "bench/results/plan_yaml.h"
#include "bench/scenario/plan.h"
#include "core/config/settings.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

std::string runs_text(const ScenarioPlan& plan) {
  std::string text;
  for (std::size_t i = 0; i < plan.scenario.variants.size(); ++i) {
    const PlannedRuns& planned = plan.planned[i];
    text += yaml_scalar(plan.scenario.variants[i].name) + ":\n";
    for (std::size_t k = 0; k < planned.sources.size(); ++k) {
      const std::string name = k == 0 ? "source" : plan.experiment->further_logs[k - 1];
      text += "  " + yaml_scalar(name) + ":\n" + indented(planned.sources[k]->complete_yaml, 4);
    }
    text += "  experiment:\n" + indented(planned.experiment.complete_yaml, 4);
  }
  return text;
}

}  // namespace

std::string identity_text(const ScenarioPlan& plan) {
  return design_yaml(plan.results) + runs_text(plan);
}

std::string config_text(const ScenarioPlan& plan) {
  return "scenario:\n" + indented(plan_yaml(plan.results), 2) +
         "runs:  # all options of each variant, at the first level of a sweep\n" +
         indented(runs_text(plan), 2);
}

}  // namespace mapbed
