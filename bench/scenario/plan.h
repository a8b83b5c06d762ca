#pragma once

#include <string>
#include <vector>

#include "bench/experiments/experiment.h"
#include "bench/results/results.h"
#include "bench/scenario/scenario.h"
#include "bench/sources/log_source.h"

namespace mapbed {

// The runs of one level and variant.
struct PlannedRuns {
  DividedSettings settings;
  std::string experiment_yaml;  // complete
  SourcePlan source;            // empty where the experiment needs no log
};

// A scenario that was checked through and through: nothing in its file can stop it any more.
struct ScenarioPlan {
  Scenario scenario;
  const Experiment* experiment = nullptr;
  Results results;                   // all but the rows; with its complete config.yaml
  std::vector<PlannedRuns> planned;  // by level and variant, the last one fastest

  int runs() const;                     // with those that are skipped because their log is not here
  std::vector<int> runs_to_do() const;  // numbers of the others
  RunRow row(int run) const;            // number, level, variant and seed
  const PlannedRuns& planned_of(const RunRow& row) const;
};

// All below throw InputError with place, reason and remedy.
PlannedRuns planned_runs(const Scenario& scenario, const Experiment& experiment, const Level& level,
                         const Variant& variant, SimulationParts& parts);
ScenarioPlan make_plan(Scenario scenario);

}  // namespace mapbed
