// What an experiment needs of its logs, with experiments that stand in no table.

#include <deque>
#include <fstream>

#include <gmock/gmock.h>

#include "bench/scenario/identity.h"
#include "bench/scenario/runner.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

struct NoOptions {};

template <class Visitor>
void visit_fields(NoOptions& /*o*/, Visitor&& /*visit*/) {}

std::vector<double> first_ranges(const SensorLog& log) {
  for (const Measurement& measurement : log) {
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) return scan->ranges;
  }
  return {};
}

double length_of(const Trajectory& truth) {
  return truth.empty() ? 0.0 : path_length(truth);
}

// How long the drives are, and where they end, as far as a run is told.
RunOutcome measured_logs(const NoOptions& /*options*/, const RunInput& input) {
  RunOutcome outcome;
  outcome.values.emplace_back("length", length_of(input.truth));
  if (!input.further.contains("mapping")) return outcome;
  const LogInput& mapping = input.further.at("mapping");
  outcome.values.emplace_back("mapping_length", length_of(mapping.truth));
  outcome.values.emplace_back("same_log", first_ranges(mapping.log) == first_ranges(input.log));
  return outcome;
}

Experiment experiment(Experiment::Needs needs, std::vector<std::string> further_logs = {}) {
  Experiment experiment = make_experiment<NoOptions>(
      "test", "for tests", needs,
      {{"length", Unit::meter, "of the drive"},
       {"mapping_length", Unit::meter, "of the drive that is mapped"},
       {"same_log", Unit::none, "1: both have the very same measurements"}},
      measured_logs);
  experiment.further_logs = std::move(further_logs);
  return experiment;
}

class Needs : public ::testing::Test {
 protected:
  ScenarioPlan plan(const std::string& yaml, Experiment experiment) {
    std::ofstream(folder_.file("x.yaml")) << yaml;
    experiments_.push_back(std::move(experiment));
    return make_plan(load_scenario(folder_.file("x.yaml")), experiments_.back());
  }
  // Of a plan with a single run.
  static RunRow row_of(const ScenarioPlan& plan) {
    RunRow row;
    do_runs(plan, {0}, 1,
            {[&row](const RunResult& result) { row = result.row; }, [] { return true; }});
    return row;
  }
  // The same drive again as a log without the truth.
  std::string log_without_truth() const {
    std::ofstream(folder_.file("drive.log")) << "FLASER 3 1.0 1.0 1.0 0 0 0 0 0 0 0.0 host 0.0\n"
                                                "FLASER 3 1.0 1.0 1.0 0 0 0 0 0 0 0.2 host 0.2\n";
    return folder_.file("drive.log");
  }

  TemporaryFolder folder_;
  std::deque<Experiment> experiments_;  // plans point to them
};

constexpr const char* kDrive =
    "world: office\nrobot: pioneer\npath: ring\npeople: 0\nrecorder.longest: 3 s\n";

TEST_F(Needs, WhatALogCannotGiveIsRefusedBeforeARun) {
  const std::string log =
      "log: " + log_without_truth() + "\nlog.field_of_view: 180 deg\nmetrics: [length]\n";
  EXPECT_EQ(row_of(plan(log, experiment(Experiment::Needs::log))).failure, "");
  EXPECT_INPUT_ERROR(plan(log, experiment(Experiment::Needs::truth)),
                     "x.yaml:1: the experiment test needs a log with the true path, and this "
                     "recorded log has no true path; give 'world' and 'robot' instead");
  EXPECT_INPUT_ERROR(plan(log, experiment(Experiment::Needs::world)),
                     "this recorded log has no world");
  EXPECT_INPUT_ERROR(plan(log, experiment(Experiment::Needs::nothing)),
                     "'log' says nothing to the experiment test, which needs no log; take it out");
}

// Of an option that names a file: the first value's is not here.
TEST_F(Needs, RunsWhoseFileIsNotHereAreSkipped) {
  const std::string yaml = "metrics: [length]\nseeds: 2\ncompare: {a: {}, b: {seeds: 1}}\n";
  int configured = 0;
  Experiment some = experiment(Experiment::Needs::nothing);
  const auto configure = some.configure;
  some.configure = [&configured, configure](const Settings& settings) {
    auto result = configure(settings);
    if (++configured == 1) result.missing = "the file is not here";
    return result;
  };
  const ScenarioPlan plan = this->plan(yaml, some);
  EXPECT_THAT(plan.results.skipped, ::testing::ElementsAre("the file is not here: 2 runs skipped"));
  EXPECT_THAT(plan.runs_to_do(), ::testing::ElementsAre(1));
  some.configure = [configure](const Settings& settings) {
    auto result = configure(settings);
    result.missing = "the file is not here";
    return result;
  };
  EXPECT_INPUT_ERROR(this->plan(yaml, some), "the file is not here; set MAPBED_DATA");
}

TEST_F(Needs, ASimulatedLogGivesEverything) {
  const std::string drive = kDrive + std::string("metrics: [length]\n");
  for (const auto needs :
       {Experiment::Needs::log, Experiment::Needs::truth, Experiment::Needs::world}) {
    EXPECT_GT(row_of(plan(drive, experiment(needs))).values[0], 0.5);
  }
}

TEST_F(Needs, AFurtherLogHasWhatDiffersUnderItsName) {
  const ScenarioPlan plan =
      this->plan(kDrive + std::string("mapping: {recorder.longest: 6 s}\n"
                                      "metrics: [length, mapping_length, same_log]\n"),
                 experiment(Experiment::Needs::truth, {"mapping"}));
  EXPECT_EQ(recordings_needed(plan), 2);
  const RunRow row = row_of(plan);
  EXPECT_GT(row.values[1], 1.5 * row.values[0]);  // twice as long, from standing
  EXPECT_THAT(plan.results.config_yaml, ::testing::HasSubstr("    mapping:\n"));
}

TEST_F(Needs, AFurtherLogWithTheSameSettingsIsAnotherDrive) {
  const ScenarioPlan plan =
      this->plan(kDrive + std::string("metrics: [length, mapping_length, same_log]\n"),
                 experiment(Experiment::Needs::truth, {"mapping"}));
  const RunRow row = row_of(plan);
  EXPECT_NEAR(row.values[0], row.values[1], 0.2 * row.values[0]);
  EXPECT_EQ(row.values[2], 0.0);
}

// At both levels: what is swept is no more of one log than of the other.
TEST_F(Needs, FurtherLogsComeBackFromTheConfiguration) {
  const ScenarioPlan plan =
      this->plan(kDrive + std::string("mapping: {world: corridor, path: there_and_back}\n"
                                      "sweep: {recorder.longest: [2 s, 3 s]}\n"
                                      "metrics: [length, mapping_length]\n"),
                 experiment(Experiment::Needs::truth, {"mapping"}));
  const ScenarioPlan again =
      this->plan(plan.results.config_yaml, experiment(Experiment::Needs::truth, {"mapping"}));
  EXPECT_EQ(again.results.config_yaml, plan.results.config_yaml);
  EXPECT_EQ(identity_of(again), identity_of(plan));
}

TEST_F(Needs, MistakesInAFurtherLogAreFoundBeforeARun) {
  EXPECT_INPUT_ERROR(plan(kDrive + std::string("mapping: {robot.odometry.rat: 1 Hz}\n"
                                               "metrics: [length]\n"),
                          experiment(Experiment::Needs::log, {"mapping"})),
                     "x.yaml:6: unknown key 'rat'");
}

}  // namespace
}  // namespace mapbed
