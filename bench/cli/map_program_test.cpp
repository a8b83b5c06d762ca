// `mapbed map` with programs of somebody else's as methods.

#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "bench/cli/testing/command_test.h"
#include "bench/process/child_process.h"
#include "core/geometry/trajectory.h"
#include "core/geometry/tum_file.h"
#include "core/log/dialects/carmen_log.h"
#include "core/log/log_file.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

class MapByProgram : public CommandTest {
 protected:
  MapByProgram() {
    write_carmen_log(path("room.log"), drive_through(rectangular_room(6.0, 4.0),
                                                     {{-1.0, 0.0}, {1.5, 0.5}}, {}, Rng(1)));
    fs::create_directory(path("tmp"));
  }
  void script(const std::string& text) const {
    write("my.yaml", "about: A script\nprogram: sh\nshell: |\n  " + text + "\n");
  }
  Outcome map(const std::string& method, const std::string& log = "room.log") const {
    return run_shell("TMPDIR=tmp exec \"$MAPBED\" map " + log + " --out m --method " + method,
                     path());
  }
  void expect_failure(const std::string& text, const std::string& message) const {
    script(text);
    expect_refused(map("./my.yaml"), message);
    EXPECT_FALSE(fs::exists(path("m/summary.json")));
    EXPECT_TRUE(fs::is_empty(path("tmp")));
  }
};

constexpr const char* kOdometry =
    "awk '/^ROBOTLASER/ {print $(NF-2), $(NF-10), $(NF-9), $(NF-8)}' {log} >trajectory.tum";

TEST_F(MapByProgram, IsAMapLikeAnyOther) {
  script(kOdometry);
  const Outcome outcome = map("./my.yaml --seed 7");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nmy: "));
  const auto summary = nlohmann::json::parse(text("m/summary.json"));
  EXPECT_EQ(summary["method"], "my");
  EXPECT_EQ(summary["complete"], true);
  EXPECT_EQ(summary["program"]["files"].size(), 2u);
  EXPECT_EQ(load_trajectory(path("m/trajectory.tum")).size(), summary["scans_in_log"]);
  EXPECT_TRUE(fs::exists(path("m/map.pgm")));
  EXPECT_TRUE(fs::is_empty(path("tmp")));

  // Its configuration gives the same again.
  EXPECT_THAT(text("m/config.yaml"), HasSubstr("method: " + path("my.yaml")));
  const Outcome again = call({"map", "room.log", "--config", "m/config.yaml", "--out", "n"});
  ASSERT_EQ(again.status, 0) << again.err;
  for (const char* name : {"trajectory.tum", "map.pgm", "config.yaml"}) {
    EXPECT_EQ(text(std::string("m/") + name), text(std::string("n/") + name)) << name;
  }
}

TEST_F(MapByProgram, KeepsFilesOfTheProgram) {
  write("my.yaml", std::string("program: sh\nkeep: [graph.g2o]\nshell: |\n  ") + kOdometry +
                       "\n  echo FIX 0 >graph.g2o\n");
  EXPECT_EQ(map("./my.yaml").status, 0);
  EXPECT_EQ(text("m/program/graph.g2o"), "FIX 0\n");
}

TEST_F(MapByProgram, TellsHowItFailedAndWhereItsMessagesAre) {
  expect_failure("echo begin; echo 'no loop' >&2; exit 3; : {log}",
                 "my ended with exit status 3; it said 'no loop', all of it is in "
                 "m/program_messages.txt");
  EXPECT_EQ(text("m/program_messages.txt"), "begin\nno loop\n");
  expect_failure("true {log}", "my: wrote no trajectory.tum");
  expect_failure("echo 1 2 3 >trajectory.tum; true {log}", "my: trajectory.tum:1: has 3 numbers");
  expect_failure("echo 1 2 3 nan >trajectory.tum; true {log}",
                 "my: trajectory.tum:1: 'nan' is not a number");
  expect_failure("echo 1 2 3 4 >trajectory.tum; true {log}", "my: has poses for 0 of the log's ");
  EXPECT_EQ(text("m/program_messages.txt"), "");
  script(kOdometry);
  EXPECT_EQ(map("./my.yaml").status, 0);
  EXPECT_FALSE(fs::exists(path("m/program_messages.txt"))) << "of an earlier call";
}

TEST_F(MapByProgram, EndsItAtItsLimit) {
  script("sleep 100; true {log}");
  expect_refused(map("./my.yaml --set my.limit='100 ms'"), "my was ended after its limit of 0.1 s");
}

TEST_F(MapByProgram, RefusesAMethodsFileThatIsWrong) {
  write("my.yaml", "command: [no_such_slam, '{log}']\ninstall: apt-get install slam-apps\n");
  expect_refused(map("./my.yaml"),
                 "my.yaml:1: the program 'no_such_slam' is not there, or cannot "
                 "be run; apt-get install slam-apps");
  write("my.yaml", "comand: [cp, '{log}']\n");
  expect_refused(map("./my.yaml"), "my.yaml");
  expect_refused(map("./none.yaml"), "none.yaml: there is no such file");
  expect_refused(map("odometry_in_pyton"), "did you mean 'odometry_in_python'?");
  script(kOdometry);
  expect_refused(map("./my.yaml --set my.limt='1 s'"), "unknown key 'limt' in my");
  expect_refused(map("./my.yaml --set rbpf.particles=3"),
                 "'rbpf.particles' is set, but the method is my");
}

TEST_F(MapByProgram, DescribesAMethodsFile) {
  script(kOdometry);
  const Outcome outcome = call({"describe", "my.yaml"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("limit: 3600 s"));
  EXPECT_THAT(outcome.out, HasSubstr("/sh\n"));
  EXPECT_THAT(call({"describe", "odometry_in_python"}).out, HasSubstr("command: [python3"));
  EXPECT_THAT(call({"list", "methods"}).out, HasSubstr("mrpt_icp_slam"));
  EXPECT_THAT(call({"list", "formats"}).out, HasSubstr("rawlog"));
}

TEST_F(MapByProgram, EndsTheProgramWhereItIsInterrupted) {
  script("echo $$ >" + path("number") + "x; mv " + path("number") + "x " + path("number") +
         "; sleep 100; true {log}");
  const Outcome outcome = run_shell(
      "TMPDIR=tmp $MAPBED map room.log --method ./my.yaml --out m & p=$!\n"
      "until [ -e number ]; do sleep 0.01; done\n"
      "kill -INT $p; wait $p; s=$?; kill -0 $(cat number) && exit 99; exit $s",
      path());
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("mapbed: interrupted "));
  EXPECT_TRUE(fs::is_empty(path("tmp")));
  EXPECT_FALSE(fs::exists(path("m")));
}

TEST_F(MapByProgram, LeavesNothingOfItWhereItIsKilled) {
  script("echo $$ >" + path("number") + "x; mv " + path("number") + "x " + path("number") +
         "; sleep 100; true {log}");
  const Outcome outcome = run_shell(
      "TMPDIR=tmp $MAPBED map room.log --method ./my.yaml --out m & p=$!\n"
      "until [ -e number ]; do sleep 0.01; done\n"
      "kill -KILL $p; wait $p\n"
      "for i in $(seq 500); do\n"
      "  kill -0 $(cat number) 2>/dev/null || [ -n \"$(ls tmp)\" ] || exit 0; sleep 0.01\n"
      "done; exit 99",
      path());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(MapByProgram, TakesTheExampleInPython) {
  if (program_in_path("python3").empty()) GTEST_SKIP() << "python3 is not installed";
  const Outcome outcome = map("odometry_in_python");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(call({"map", "room.log", "--out", "ours", "--method", "odometry"}).status, 0);
  const Trajectory ours = load_trajectory(path("ours/trajectory.tum"));
  const Trajectory theirs = load_trajectory(path("m/trajectory.tum"));
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_NEAR(path_length(ours), path_length(theirs), 1e-6);
}

TEST_F(MapByProgram, WritesRawlogsThatMrptReads) {
  if (program_in_path("rawlog-edit").empty()) GTEST_SKIP() << "mrpt-apps is not installed";
  write("my.yaml",
        "program: rawlog-edit\nlog: rawlog\nkeep: [info.txt, scans.txt]\nshell: |\n"
        "  rawlog-edit --info -i {log} >info.txt\n"
        "  cp {log} x.rawlog; rawlog-edit --export-2d-scans-txt -i x.rawlog\n"
        "  mv x_front.txt scans.txt\n"
        "  awk '{print $1, 0, 0, 0}' {stamps} >trajectory.tum\n");
  ASSERT_EQ(map("./my.yaml").status, 0);
  const RecordedLog log = load_log(path("room.log"));
  std::vector<LaserScan> scans;
  for (const Measurement& measurement : log.measurements) {
    if (const auto* scan = std::get_if<LaserScan>(&measurement)) scans.push_back(*scan);
  }
  const std::string info = text("m/program/info.txt");
  EXPECT_THAT(info, ::testing::ContainsRegex(
                        "Overall number of objects *: " + std::to_string(2 * scans.size()) + "\n"));
  EXPECT_THAT(info, ::testing::ContainsRegex("Actions/SensoryFrame format *: Yes"));
  // A line each: time, ranges, whether they are measurements.
  std::istringstream lines(text("m/program/scans.txt"));
  std::string head;
  std::getline(lines, head);
  for (const LaserScan& scan : scans) {
    double time = 0.0;
    ASSERT_TRUE(lines >> time);
    EXPECT_NEAR(time, scan.time, 1e-6);
    std::vector<double> ranges(scan.ranges.size()), valid(scan.ranges.size());
    for (double& range : ranges) lines >> range;
    for (double& beam : valid) lines >> beam;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      EXPECT_NEAR(ranges[i], scan.ranges[i], 0.001);  // three decimals
      EXPECT_EQ(valid[i] == 1.0, scan.is_hit(i));
    }
  }
}

// Its map of a loop is right within the width of a door.
TEST_F(MapByProgram, TakesIcpSlamOfMrpt) {
  if (program_in_path("icp-slam").empty()) GTEST_SKIP() << "icp-slam (mrpt-apps) is not installed";
  ASSERT_EQ(map("mrpt_icp_slam", "example").status, 0);
  ASSERT_EQ(call({"map", "example", "--out", "ours", "--method", "scan_matching"}).status, 0);
  const Trajectory ours = load_trajectory(path("ours/trajectory.tum"));
  const Trajectory theirs = load_trajectory(path("m/trajectory.tum"));
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_NEAR(path_length(ours), path_length(theirs), 0.03 * path_length(ours));
  const Pose2 apart = motion_between(inverse(ours.front().pose) * ours.back().pose,
                                     inverse(theirs.front().pose) * theirs.back().pose);
  EXPECT_LT(apart.position().norm(), 0.8);
}

}  // namespace
}  // namespace mapbed
