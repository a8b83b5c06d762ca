// A run that throws: it stays in the table with its reason, and the others go on.

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>

#include "bench/results/result_folder.h"
#include "bench/scenario/run_scenario.h"
#include "core/input_error.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

struct FailingOptions {
  bool fails = false;
};

template <class Visitor>
void visit_fields(FailingOptions& o, Visitor&& visit) {
  visit("fails", o.fails, "the run throws");
}

RunOutcome answer(const FailingOptions& options, const RunInput& /*input*/) {
  if (options.fails) throw InputError("the map is\nempty, it says");
  return {.values = {{"answer", 42.0}}};
}

Experiment failing_experiment() {
  return make_experiment<FailingOptions>(
      "failing", "for tests", Experiment::Needs::nothing,
      {{"answer", Unit::none, "of each run"}, {"failures", Unit::none, "1: it failed", 1.0}},
      answer);
}

TEST(FailingRuns, StandInTheTableWithTheirReasonAndTheOthersGoOn) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("x.yaml")) << "metrics: [answer, failures]\nseeds: 3\n"
                                          "compare: {well: {fails: false}, ill: {fails: true}}\n"
                                          "claims: [{metric: answer, equals: 42, within: 0},\n"
                                          "         {metric: failures, of: ill, at_least: 1}]\n";
  const Experiment experiment = failing_experiment();
  const ScenarioPlan plan = make_plan(load_scenario(folder.file("x.yaml")), experiment);
  const ScenarioRun run = run_scenario(plan, {.folder = folder.file("."), .threads = 2},
                                       [](std::size_t, std::size_t) { return true; });
  ASSERT_TRUE(run.complete);

  const Results results = load_results(folder.file("."));
  ASSERT_EQ(results.runs.size(), 6u);
  for (const RunRow& row : results.runs) {
    const bool is_well = row.variant == 0;
    EXPECT_EQ(row.failure, is_well ? "" : "the map is empty, it says") << row.run;  // one line
    EXPECT_EQ(std::isnan(row.values.at(0)), !is_well) << row.run;
    // A metric may have a value in a run that failed; of one that did not, this one has none.
    EXPECT_EQ(is_well ? 1.0 : row.values.at(1), 1.0) << row.run;
  }
  ASSERT_EQ(results.verdicts.size(), 2u);
  EXPECT_FALSE(results.verdicts[0].held) << "runs without a value speak against it";
  EXPECT_TRUE(results.verdicts[1].held);
}

// In the first 0.2 s a robot has come no 5 cm far.
TEST(FailingRuns, ARobotThatGotStuckIsToldOnceForAllRunsOfItsRecording) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("x.yaml"))
      << "world: corridor\nrobot: pioneer\npeople: 0\nrecorder.stuck_after: 0.2 s\n"
         "compare: {raw: {estimator: odometry}, again: {estimator: odometry}}\n"
         "metrics: [path_length]\n";
  const ScenarioRun run =
      run_scenario(make_plan(load_scenario(folder.file("x.yaml"))), {.folder = folder.file(".")},
                   [](std::size_t, std::size_t) { return true; });
  ASSERT_EQ(run.remarks.size(), 1u);
  EXPECT_THAT(run.remarks[0], ::testing::StartsWith("seed 1: the robot has stood at ("));
}

}  // namespace
}  // namespace mapbed
