#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/experiments/experiment.h"
#include "bench/results/results.h"
#include "bench/scenario/scenario.h"
#include "bench/sources/log_source.h"

namespace mapbed {

// The runs of one level and variant, with all their settings bound.
struct PlannedRuns {
  Configured<RunOutcome(const RunInput&)> experiment;
  // The scenario's own log, then Experiment::further_logs; empty where the experiment needs none.
  // Runs with the same settings share them.
  std::vector<std::shared_ptr<const SourcePlan>> sources = {};

  std::string missing() const;  // why there is nothing to work on; empty: all files are here
};

// Sources by their settings, so that each is planned once, however many runs have it.
class PlannedSources {
 public:
  explicit PlannedSources(const Experiment& experiment) : experiment_(experiment) {}

  // Throws InputError also where it cannot give what the experiment needs.
  std::shared_ptr<const SourcePlan> planned(const Settings& settings);

 private:
  const Experiment& experiment_;
  SourceParts parts_;
  std::map<std::string, std::shared_ptr<const SourcePlan>> by_settings_;
};

// A scenario that was checked through and through: nothing in its file can stop it any more.
struct ScenarioPlan {
  Scenario scenario;
  const Experiment* experiment = nullptr;
  Results results;                   // all but the rows; with its complete config.yaml
  std::vector<PlannedRuns> planned;  // by level and variant, the last one fastest

  // With those that are not done: because their log is not here, or their variant has fewer seeds.
  int runs() const;
  std::vector<int> runs_to_do() const;  // numbers of the others
  RunRow row(int run) const;            // number, level, variant and seed
  const PlannedRuns& planned_of(const RunRow& row) const;
  int seeds_of(int variant) const;
};

// All below throw InputError with place, reason and remedy.
PlannedRuns planned_runs(const Scenario& scenario, const Experiment& experiment, const Level& level,
                         const Variant& variant, PlannedSources& sources);
ScenarioPlan make_plan(Scenario scenario);  // of the experiment that it names
ScenarioPlan make_plan(Scenario scenario, const Experiment& experiment);  // which must live on

}  // namespace mapbed
