#include "bench/scenario/scenario_log.h"

#include <fstream>

#include <gmock/gmock.h>

#include "bench/scenario/plan.h"
#include "bench/sources/log_source.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

class ScenarioLog : public ::testing::Test {
 protected:
  ScenarioLog() {
    write("drive.yaml",
          "world: office\nrobot: pioneer\npeople: 0\nrecorder.longest: 1 s\nmetrics: [failures]\n");
  }
  Scenario scenario(const std::string& yaml, const std::string& set = "") const {
    ScenarioChoice choice;
    if (!set.empty()) choice.settings.push_back(parse_setting(set));
    return load_scenario(write("x.yaml", "base: drive.yaml\n" + yaml), choice);
  }

  TemporaryFolder folder_;

 private:
  std::string write(const std::string& name, const std::string& yaml) const {
    std::ofstream(folder_.file(name)) << yaml;
    return folder_.file(name);
  }
};

std::vector<double> ranges_of(const SensorLog& log) {
  std::vector<double> ranges;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan != nullptr) ranges.insert(ranges.end(), scan->ranges.begin(), scan->ranges.end());
  }
  return ranges;
}

TEST_F(ScenarioLog, IsTheOneOnWhichItsRunsWork) {
  const Scenario scenario = this->scenario("seed: 5\ncompare: {a: {estimator: odometry}}\n");
  const SensorLog alone = run_simulation(simulation_in(scenario), 5).log;
  const ScenarioPlan plan = make_plan(scenario);
  const SourcePlan& source = *plan.planned.front().sources.front();
  const SensorLog of_runs = open_source(source, 5)->input(source, 5).log;
  EXPECT_FALSE(ranges_of(alone).empty());
  EXPECT_EQ(ranges_of(alone), ranges_of(of_runs));
}

TEST_F(ScenarioLog, IsOneWhereOnlyTheMethodsDiffer) {
  const Scenario scenario = this->scenario(
      "sweep: {path_length: [5 m, 10 m]}\n"
      "compare: {a: {estimator: odometry}, b: {estimator: scan_matching}}\n");
  EXPECT_EQ(simulation_in(scenario).world->name, "office");
}

TEST_F(ScenarioLog, IsChosenByVariantAndLevelWhereThereAreSeveral) {
  const std::string yaml =
      "sweep: {robot.odometry.rotation_sigma: [0 deg, 3 deg]}\n"
      "compare: {a: {path: ring}, b: {path: tour}}\n";
  EXPECT_INPUT_ERROR(simulation_in(scenario(yaml)),
                     "it sweeps 'robot.odometry.rotation_sigma', so "
                     "it has several logs; choose one, as in --set "
                     "'robot.odometry.rotation_sigma=3 deg'");
  const std::string level = "robot.odometry.rotation_sigma=3 deg";
  EXPECT_INPUT_ERROR(simulation_in(scenario(yaml, level)),
                     "its variants have different logs; choose one, as in --variant 'b'");
  EXPECT_INPUT_ERROR(simulation_in(scenario(yaml, level), "c"), "'c' is not compared");
  EXPECT_EQ(simulation_in(scenario(yaml, level), "b").path.name, "tour");
}

TEST_F(ScenarioLog, MistakesAreFoundAsBeforeARun) {
  EXPECT_INPUT_ERROR(simulation_in(scenario("robot.odometry.rotaton_sigma: 1 deg\n")),
                     "did you mean 'rotation_sigma'?");
  EXPECT_INPUT_ERROR(simulation_in(scenario("estimator: scan_maching\n")),
                     "did you mean 'scan_matching'?");
}

}  // namespace
}  // namespace mapbed
