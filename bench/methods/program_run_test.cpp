#include "bench/methods/program_run.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "bench/methods/method_run.h"
#include "core/log/log_file.h"
#include "core/testing/is_near.h"
#include "core/testing/temporary_folder.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Ten scans, 0.1 m and 0.1 s apart, from 100 s on; the robot drives along x.
SensorLog straight_log() {
  SensorLog log;
  for (int i = 0; i < 10; ++i) {
    const double time = 100.0 + 0.1 * i;
    log.push_back(Odometry{.time = time, .odometry_from_robot = {0.1 * i, 0.0, 0.0}});
    LaserScan scan{.time = time, .first_bearing = -0.5, .bearing_step = 0.5, .max_range = 8.0};
    scan.ranges = {1.0, 2.0, 8.0};
    log.push_back(scan);
  }
  return log;
}

// Dead reckoning in a line.
constexpr const char* kOdometry =
    "awk '/^ROBOTLASER/ {print $(NF-2), $(NF-10), $(NF-9), $(NF-8)}' {log} >trajectory.tum";

ProgramMethod script(const std::string& text) {
  return {.name = "my", .command = {text}, .is_shell = true, .limit = 20.0};
}

ProgramRun run(const ProgramMethod& method) {
  return run_program_method(method, straight_log(), straight_log(), 7);
}

void expect_failed(const ProgramMethod& method, const std::string& reason) {
  EXPECT_INPUT_ERROR(run(method), reason);
}

Trajectory path(double from, double to, double step) {
  Trajectory poses;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) {
    const double time = from + i * step;
    poses.push_back({time, {time - 100.0, 0.0, 0.0}});
  }
  return poses;
}

TEST(ProgramRun, GivesAPoseForEachScan) {
  const ProgramRun result = run(script(kOdometry));
  ASSERT_EQ(result.estimate.trajectory.size(), 10u);
  EXPECT_THAT(result.estimate.trajectory.back().pose, IsNear({0.9, 0.0, 0.0}, {1e-9, 1e-9}));
  EXPECT_THAT(result.estimate.remarks, IsEmpty());
  EXPECT_GT(result.cost.wall_seconds, 0.0);
}

TEST(ProgramRun, IsTheSameAsACommandWithoutAShell) {
  ProgramMethod method = script("");
  method.is_shell = false;
  method.command = {"awk", "/^ROBOTLASER/ {print $(NF-2), $(NF-10), 0, 0 >\"trajectory.tum\"}",
                    "{log}"};
  EXPECT_EQ(run(method).estimate.trajectory.size(), 10u);
}

TEST(ProgramRun, GivesTheLogGeometryStampsSeedAndOptions) {
  ProgramMethod method = script(std::string(kOdometry) +
                                "; cp {log} log; cp {geometry} geometry; cp {stamps} stamps;"
                                "echo {seed} {gain} >said; pwd >here; echo {out} >out");
  method.options = {{"gain", "a  'b"}};
  method.keep = {"log", "geometry", "stamps", "said", "here", "out"};
  const auto kept = run(method).kept;
  ASSERT_EQ(kept.size(), 6u);
  EXPECT_EQ(parse_log("log", kept[0].second).measurements.size(), 20u);
  EXPECT_EQ(nlohmann::json::parse(kept[1].second)["lasers"][0]["beams"], 3);
  EXPECT_THAT(kept[2].second, ::testing::StartsWith("100.000000\n100.100000\n"));
  EXPECT_EQ(kept[3].second, "7 a  'b\n");
  EXPECT_EQ(kept[4].second, kept[5].second);
  const std::string folder = kept[4].second.substr(0, kept[4].second.size() - 1);
  EXPECT_FALSE(std::filesystem::exists(folder)) << "it goes afterwards";
}

TEST(ProgramRun, TellsOfAFileThatItWasToKeepAndDidNotWrite) {
  ProgramMethod method = script(kOdometry);
  method.keep = {"map.pgm"};
  const ProgramRun result = run(method);
  EXPECT_THAT(result.kept, IsEmpty());
  EXPECT_EQ(result.estimate.remarks.at(0).text, "my wrote no map.pgm, which it was to keep");
}

TEST(ProgramRun, FailsWithItsExitStatusAndKeepsItsMessages) {
  try {
    run(script("echo no loop >&2; exit 3; : {log}"));
    FAIL();
  } catch (const ProgramFailed& error) {
    EXPECT_STREQ(error.what(), "my ended with exit status 3");
    EXPECT_EQ(error.messages, "no loop\n");
  }
}

TEST(ProgramRun, FailsAtTheFirstCommandOfAScriptThatFails) {
  expect_failed(script("false; " + std::string(kOdometry)), "my ended with exit status 1");
}

TEST(ProgramRun, FailsAtItsLimit) {
  ProgramMethod method = script("sleep 100");
  method.limit = 0.1;
  expect_failed(method, "my was ended after its limit of 0.1 s");
}

TEST(ProgramRun, FailsWhereItIsKilled) {
  expect_failed(script("kill -ABRT $$"), "my was ended by signal 6 (Aborted)");
}

TEST(ProgramRun, FailsWithoutATrajectory) {
  expect_failed(script("true"), "my: wrote no trajectory.tum; it is to write it into the folder");
  expect_failed(script("touch trajectory.tum"), "my: trajectory.tum: holds no pose");
}

TEST(ProgramRun, FailsWithATrajectoryThatIsNone) {
  expect_failed(script("echo '100 0 0 0' >trajectory.tum; echo 100.9 0 0 >>trajectory.tum"),
                "my: trajectory.tum:2: has 3 numbers; lines are `t x y z qx qy qz qw` or");
  expect_failed(script("echo '100 0 nan 0' >trajectory.tum"),
                "my: trajectory.tum:1: 'nan' is not a number");
  expect_failed(script("echo '100 0 0 0 0 0 0 2' >trajectory.tum"),
                "my: trajectory.tum:1: the quaternion has length 2, not 1");
}

TEST(ProgramRun, FailsWithStampsThatAreNotTheLogs) {
  expect_failed(script("echo '0 0 0 0' >trajectory.tum; echo '9 0 0 0' >>trajectory.tum"),
                "my: has poses for 0 of the log's 10 scans: its stamps go from 0.000 to 9.000, the "
                "log's from 100.000 to 100.900");
}

TEST(ProgramRun, IsRefusedWhereAFileOfItsOwnHasChanged) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("settings.ini")) << "a = 1\n";
  ProgramMethod method = script(kOdometry);
  method.input_files = {input_file(folder.file("settings.ini"))};
  EXPECT_EQ(run(method).estimate.trajectory.size(), 10u);
  std::ofstream(folder.file("settings.ini")) << "a = 2\n";
  EXPECT_THROW(run(method), InputChanged);
}

TEST(ProgramRun, EndsWhereNobodyWantsItAnyMore) {
  int asked = 0;
  EXPECT_THROW(run_program_method(script("sleep 100"), straight_log(), straight_log(), 1,
                                  [&] { return ++asked < 3; }),
               Interrupted);
}

TEST(EstimateAtScans, InterpolatesBetweenPoses) {
  const Estimate estimate = estimate_at_scans("my", path(100.0, 101.0, 0.5), straight_log());
  ASSERT_EQ(estimate.trajectory.size(), 10u);
  for (const auto& [time, pose] : estimate.trajectory) EXPECT_NEAR(pose.x, time - 100.0, 1e-9);
}

TEST(EstimateAtScans, LeavesScansOutsideWithoutAPoseAndTellsHowMany) {
  const Estimate estimate = estimate_at_scans("my", path(100.05, 101.0, 0.1), straight_log());
  EXPECT_EQ(estimate.trajectory.size(), 9u);
  EXPECT_EQ(estimate.trajectory.front().time, 100.1);
  EXPECT_EQ(estimate.remarks.at(0).text,
            "my has poses for 9 of 10 scans; those before its first and after its last pose are "
            "left out");
  EXPECT_INPUT_ERROR(estimate_at_scans("my", path(100.15, 101.0, 0.1), straight_log()),
                     "my: has poses for 8 of the log's 10 scans");
}

TEST(EstimateAtScans, TakesAStampThatWasRoundedForTheScans) {
  Trajectory rounded = path(100.0, 100.9, 0.3);
  rounded.front().time += 0.0004;  // as of three decimals
  rounded.back().time -= 0.0004;
  EXPECT_EQ(estimate_at_scans("my", rounded, straight_log()).trajectory.size(), 10u);
}

TEST(EstimateAtScans, LeavesTiltedLasersOutAsMethodsOfOursDo) {
  SensorLog log = straight_log();
  LaserScan tilted = std::get<LaserScan>(log[1]);
  tilted.laser = 1;
  tilted.robot_from_laser.pitch = 0.5;
  log.push_back(tilted);
  const Estimate estimate = estimate_at_scans("my", path(100.0, 101.0, 0.1), log);
  EXPECT_EQ(estimate.trajectory.size(), 10u);
  EXPECT_EQ(estimate.remarks.size(), 1u);
}

TEST(MethodRun, GivesAProgramTheLogAsItWasRecorded) {
  ChosenMethod method{.name = "my", .what = script(kOdometry)};
  SensorLog prepared = straight_log();  // odometry mended
  for (Measurement& measurement : prepared) {
    if (auto* odometry = std::get_if<Odometry>(&measurement)) odometry->odometry_from_robot = {};
  }
  const SensorLog as_recorded = straight_log();
  const MethodRun result =
      run_method(method, {.as_recorded = as_recorded, .prepared = prepared, .rng = Rng(1)});
  EXPECT_NEAR(result.estimate.trajectory.back().pose.x, 0.9, 1e-9);
}

}  // namespace
}  // namespace mapbed
