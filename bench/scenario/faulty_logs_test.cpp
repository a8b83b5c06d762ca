// Faults that a scenario puts into its logs, simulated and recorded ones.

#include <gmock/gmock.h>

#include "bench/results/results.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/runner.h"
#include "bench/scenario/scenario_log.h"
#include "bench/scenario/testing/own_files.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kDrive =
    "about: a short drive\nexperiment: log_faults\nestimator: odometry\n"
    "metrics: [error, clean_error, odometry_error, told, kept]\n";

std::vector<double> stamps_of_odometry(const SensorLog& log) {
  std::vector<double> stamps;
  for (const Measurement& measurement : log) {
    if (const auto* reading = std::get_if<Odometry>(&measurement)) stamps.push_back(reading->time);
  }
  return stamps;
}

class FaultyLogs : public OwnFiles {
 protected:
  std::string simulated(const std::string& more) const {
    return write("x.yaml", std::string(kDrive) +
                               "world: room.yaml\nrobot: ours.yaml\npeople: 0\n"
                               "recorder.longest: 8 s\n" +
                               more);
  }
  std::string recorded(const std::string& more) const {
    write_log("drive.log");
    return write("x.yaml", std::string(kDrive) + "log: ./drive.log\n" + more);
  }
};

TEST_F(FaultyLogs, AreSweptLikeAnyOtherOptionOnOneRecording) {
  const ScenarioPlan plan = planned(simulated("sweep: {faults.lag.delay: [0 s, 100 ms, 1 s]}\n"));
  ASSERT_EQ(plan.planned.size(), 3u);
  EXPECT_EQ(recordings_needed(plan), 1);
  const SourcePlan& clean = *plan.planned[0].sources[0];
  const SourcePlan& late = *plan.planned[2].sources[0];
  const auto source = open_source(clean, 1);
  const LogInput before = source->input(clean, 1);
  const LogInput after = source->input(late, 1);
  EXPECT_EQ(stamps_of_odometry(after.clean), stamps_of_odometry(before.log));
  EXPECT_EQ(stamps_of_odometry(after.log).front(), stamps_of_odometry(before.log).front() + 1.0);
  ASSERT_EQ(after.faults.size(), 1u);
  EXPECT_EQ(after.faults[0].name, "lag");
  ASSERT_EQ(after.truth.size(), before.truth.size()) << "what was true stays";
  EXPECT_EQ(after.truth.back().pose, before.truth.back().pose);
}

TEST_F(FaultyLogs, AreInRecordedLogsToo) {
  const ScenarioPlan plan = planned(recorded("faults.lag.delay: 1 s\n"));
  const SourcePlan& source = *plan.planned[0].sources[0];
  const LogInput input = open_source(source, 1)->input(source, 1);
  EXPECT_EQ(stamps_of_odometry(input.log).front(), stamps_of_odometry(input.clean).front() + 1.0);
}

TEST_F(FaultyLogs, AreSimulatedAsTheRunsHaveThem) {
  const Scenario scenario = load_scenario(simulated("faults.jump.distance: 2 m\n"));
  const ScenarioPlan plan = make_plan(scenario);
  const SourcePlan& source = *plan.planned[0].sources[0];
  const SensorLog of_runs = open_source(source, 3)->input(source, 3).log;
  const SensorLog alone = run_simulation(simulation_in(scenario), 3).log;
  ASSERT_EQ(alone.size(), of_runs.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const auto* reading = std::get_if<Odometry>(&alone[i]);
    if (reading == nullptr) continue;
    EXPECT_EQ(reading->odometry_from_robot, std::get<Odometry>(of_runs[i]).odometry_from_robot);
  }
}

TEST_F(FaultyLogs, StandInTheConfigurationAndMakeOtherRuns) {
  const ScenarioPlan clean = planned(simulated(""));
  const ScenarioPlan faulty = planned(simulated("faults.stall.duration: 1 s\n"));
  EXPECT_THAT(clean.results.config_yaml, Not(HasSubstr("faults.")));
  EXPECT_THAT(faulty.results.config_yaml, HasSubstr("faults.stall.duration: 1 s"));
  EXPECT_NE(identity_of(clean), identity_of(faulty));
  const ScenarioPlan again = planned(write("config.yaml", faulty.results.config_yaml));
  EXPECT_EQ(identity_of(again), identity_of(faulty));
}

TEST_F(FaultyLogs, OfTheSameConfigurationGiveTheSameBytes) {
  const std::string yaml = simulated(
      "sweep: {fault: {none: {}, jump: {faults.jump: {distance: 2 m, at: [3 s]}}, "
      "drops: {faults.dropped_scans.fraction: 0.5}}}\nseeds: 2\n");
  const Results results = run(planned(yaml), "first");
  run(planned(path("first/config.yaml")), "second");
  EXPECT_EQ(bytes_of("first"), bytes_of("second"));
  ASSERT_EQ(results.runs.size(), 6u);
  for (const RunRow& row : results.runs) EXPECT_EQ(row.failure, "");
  EXPECT_EQ(results.runs[0].values[0], results.runs[0].values[1]) << "error and clean error";
  EXPECT_GT(results.runs[1].values[0], results.runs[1].values[1] + 0.1) << "a jump of 2 m";
}

TEST_F(FaultyLogs, AreRefusedWithTheirPlace) {
  EXPECT_INPUT_ERROR(planned(simulated("faults.stal.duration: 1 s\n")), "unknown fault 'stal'");
  EXPECT_INPUT_ERROR(planned(recorded("faults.stall.duration: 1 m\n")), "is not a time");
}

}  // namespace
}  // namespace mapbed
