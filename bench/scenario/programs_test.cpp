// Programs of somebody else's beside methods of ours in a scenario.

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/results/result_folder.h"
#include "bench/scenario/identity.h"
#include "bench/scenario/run_scenario.h"
#include "bench/scenario/testing/own_files.h"
#include "bench/sources/files_record.h"
#include "core/data_path.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Dead reckoning with a gain on distances.
constexpr const char* kProgram =
    "command: [awk, -v, 'g={gain}',\n"
    "          '/^ROBOTLASER/ {print $(NF-2), g*$(NF-10), g*$(NF-9), $(NF-8)"
    " >\"trajectory.tum\"}',\n"
    "          '{log}']\n"
    "options: {gain: 1}\n";

class Programs : public OwnFiles {
 protected:
  Programs() { write("theirs.yaml", kProgram); }

  std::string drives(const std::string& variants, const std::string& more = "") const {
    return write("x.yaml",
                 "world: room.yaml\nrobot: ours.yaml\npeople: 0\n"
                 "recorder.longest: 2 s\nseeds: 2\n"
                 "robot.odometry.distance_per_meter: 5 cm\n"
                 "metrics: [translation_error, path_length, failures]\n"
                 "compare:\n" +
                     variants + more);
  }
  ScenarioRun run_all(
      const ScenarioPlan& plan, const std::string& folder,
      const MayGoOn& may_go_on = [](std::size_t, std::size_t) { return true; },
      int threads = 2) const {
    std::filesystem::create_directories(path(folder));
    return run_scenario(plan, {.folder = path(folder), .threads = threads}, may_go_on);
  }
};

constexpr const char* kBoth =
    "  ours: {estimator: odometry}\n"
    "  theirs: {estimator: theirs.yaml}\n";

TEST_F(Programs, GetTheLogOfTheRunAndAreMeasuredAsMethodsOfOursAre) {
  const Results results = run(planned(drives(kBoth)), "r");
  ASSERT_EQ(results.runs.size(), 4u);
  for (int i = 0; i < 4; i += 2) {
    const RunRow& ours = results.runs[static_cast<std::size_t>(i)];
    const RunRow& theirs = results.runs[static_cast<std::size_t>(i) + 1];
    EXPECT_GT(ours.values[0], 1e-4) << "noise is in the log";
    EXPECT_NEAR(theirs.values[0], ours.values[0], 1e-6);
    EXPECT_NEAR(theirs.values[1], ours.values[1], 1e-6);
  }
  for (const CostRow& cost : results.costs) {
    EXPECT_GT(cost.method_wall_seconds, 0.0) << cost.run;
    EXPECT_GE(cost.seconds, cost.method_seconds) << cost.run;
  }
}

TEST_F(Programs, GetFaultsToo) {
  const Results results = run(planned(drives(kBoth, "faults.scale.by: 0.5\n")), "r");
  EXPECT_NEAR(results.runs[1].values[1], results.runs[0].values[1], 1e-6);
}

TEST_F(Programs, HaveOptionsThatAreSetAndSwept) {
  const Results results = run(planned(drives("  theirs: {estimator: theirs.yaml, seeds: 1}\n",
                                             "sweep: {theirs.gain: [1, 2]}\n")),
                              "r");
  ASSERT_EQ(results.runs.size(), 2u);
  EXPECT_NEAR(results.runs[1].values[1], 2.0 * results.runs[0].values[1], 1e-4);
}

TEST_F(Programs, GiveTheSameBytesAgainFromTheirConfigurationAndAfterAnInterrupt) {
  const ScenarioPlan plan = planned(drives(kBoth));
  run(plan, "first");
  std::filesystem::create_directories(path("copy"));
  std::filesystem::copy_file(path("first/config.yaml"), path("copy/config.yaml"));
  run(planned(path("copy/config.yaml")), "second");
  EXPECT_EQ(bytes_of("first"), bytes_of("second"));
  EXPECT_THAT(text("first/config.yaml"), HasSubstr("gain: 1"));

  const auto once = [](std::size_t done, std::size_t) { return done < 1; };
  EXPECT_FALSE(run_all(plan, "cut", once, 1).complete);
  run(plan, "cut");
  EXPECT_EQ(bytes_of("first"), bytes_of("cut"));
}

TEST_F(Programs, AreInterruptedWhileTheyRun) {
  write("theirs.yaml", "program: sleep\nshell: echo {log}; sleep 100\n");
  int asked = 0;
  const ScenarioRun run = run_all(
      planned(drives("  theirs: {estimator: theirs.yaml}\n")), "cut",
      [&](std::size_t, std::size_t) { return ++asked < 10; }, 1);
  EXPECT_FALSE(run.complete);
  EXPECT_EQ(run.results.runs.size(), 0u) << "not a failed run";
}

TEST_F(Programs, ThatFailStandInTheTableWithTheirReasonAndTheirMessages) {
  write("theirs.yaml", "program: sh\nshell: echo no loop in {log}; exit 3\n");
  const ScenarioRun run = run_all(planned(drives(kBoth)), "r");
  ASSERT_TRUE(run.complete);
  const Results results = load_results(path("r"));
  EXPECT_EQ(results.runs[1].failure, "theirs ended with exit status 3");
  EXPECT_EQ(results.runs[1].values[2], 1.0) << "a failure";
  EXPECT_EQ(results.runs[0].failure, "");
  EXPECT_THAT(text("r/messages/run_1_theirs.txt"), HasSubstr("no loop in "));
  EXPECT_THAT(text("r/messages/run_3_theirs.txt"), HasSubstr("no loop in "));
  EXPECT_THAT(text("r/files.csv"), HasSubstr("messages/run_3_theirs.txt"));
}

TEST_F(Programs, KeepFilesOfTheirOwnOfTheFirstSeed) {
  write("theirs.yaml",
        "program: awk\nkeep: [graph.g2o]\nshell: |\n"
        "  awk '/^ROBOTLASER/ {print $(NF-2), 0, 0, 0}' {log} >trajectory.tum\n"
        "  echo FIX {seed} >graph.g2o\n");
  run(planned(drives(kBoth)), "r");
  EXPECT_EQ(text("r/program/graph_theirs.g2o"), "FIX 1\n");
  std::filesystem::remove(path("r/program/graph_theirs.g2o"));
  EXPECT_TRUE(std::filesystem::is_empty(path("r/program"))) << "nothing of the second seed";
}

TEST_F(Programs, AreWhatARunIsMadeOf) {
  write("settings.ini", "a = 1\n");
  write("slam", "#!/bin/sh\n");
  std::filesystem::permissions(path("slam"), std::filesystem::perms::owner_all);
  write("theirs.yaml",
        "command: [./slam, '{log}', '{settings}']\nfiles: {settings: settings.ini}\n"
        "version: [cat, " +
            write("version", "1.0\n") + "]\n");
  const std::string x = drives(kBoth);
  for (const char* file : {"theirs.yaml", "settings.ini", "slam"}) {
    SCOPED_TRACE(file);
    const ScenarioPlan before = planned(x);
    const std::string config = write("config.yaml", before.results.config_yaml);
    write(file, text(file) + "# edited\n");
    const ScenarioPlan after = planned(x);
    EXPECT_NE(identity_of(after), identity_of(before));
    EXPECT_THAT(changed_files(config, input_files(after)), ElementsAre(portable_path(path(file))));
  }
  const ScenarioPlan before = planned(x);
  EXPECT_THAT(before.results.config_yaml, HasSubstr("# a program that states version 1.0"));
  write("version", "1.1\n");
  EXPECT_NE(identity_of(planned(x)), identity_of(before));
}

TEST_F(Programs, ThatAreNotThereStopThePlan) {
  write("theirs.yaml", "command: [no_such_slam, '{log}']\ninstall: apt-get install slam-apps\n");
  EXPECT_INPUT_ERROR(planned(drives(kBoth)),
                     "the program 'no_such_slam' is not there, or cannot be run; apt-get install "
                     "slam-apps");
  EXPECT_INPUT_ERROR(planned(drives("  x: {estimator: none.yaml}\n")), "there is no such file");
  EXPECT_INPUT_ERROR(planned(drives("  x: {estimator: mrpt_icp_slan}\n")),
                     "unknown method 'mrpt_icp_slan'; did you mean 'mrpt_icp_slam'?");
  write("theirs.yaml", kProgram);
  EXPECT_INPUT_ERROR(planned(drives("  x: {estimator: theirs.yaml, theirs.gian: 2}\n")),
                     "unknown key 'gian' in theirs; did you mean 'gain'?");
}

TEST_F(Programs, AreTakenByTheExperimentOnFaultsAsWell) {
  const std::string x =
      write("y.yaml",
            "experiment: log_faults\nworld: corridor\nrobot: ours.yaml\npeople: 0\n"
            "recorder.longest: 5 s\nestimator: theirs.yaml\nfaults.scale.by: 0.5\n"
            "metrics: [error, odometry_error]\n");
  const Results results = run(planned(x), "r");
  EXPECT_GT(results.runs.at(0).values.at(0), 0.0);
  EXPECT_GT(results.costs.at(0).method_wall_seconds, 0.0);
}

}  // namespace
}  // namespace mapbed
