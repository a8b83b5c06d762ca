// The program itself, from the command line to its exit status.

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "core/file/text_file.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

void expect_refusal(const std::vector<std::string>& arguments, const std::string& message) {
  const Outcome outcome = run_mapbed(arguments);
  expect_refused(outcome, message);
  EXPECT_EQ(outcome.out, "");
}

TEST(Program, TellsWhatItCanDo) {
  const Outcome help = run_mapbed({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"evaluate", "map", "render", "list", "describe"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    const Outcome of_command = run_mapbed({command, "--help"});
    EXPECT_EQ(of_command.status, 0);
    EXPECT_THAT(of_command.out, HasSubstr("Usage: mapbed " + std::string(command)));
  }
  EXPECT_EQ(run_mapbed({}).out, help.out);
}

TEST(Program, TellsItsRevisionAndLibraries) {
  const Outcome outcome = run_mapbed({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("mapbed "), HasSubstr("revision"), HasSubstr("Eigen")));
}

TEST(Program, SuggestsTheNearestCommandAndOption) {
  expect_refusal({"evalute"}, "unknown command 'evalute'; did you mean 'evaluate'?");
  expect_refusal({"evaluate", "x", "--relaitons=y"},
                 "unknown option '--relaitons'; did you mean '--relations'?");
  expect_refusal({"--verison"}, "unknown option '--verison'; did you mean '--version'?");
  expect_refusal({"map", "a", "b"}, "one argument too many: 'b'; see 'mapbed map --help'");
  expect_refusal({"map"}, "LOG is required; see 'mapbed map --help'");
  expect_refusal({"list", "method"}, "did you mean 'methods'?");
  expect_refusal({"describe", "odometri"}, "did you mean 'odometry'?");
}

TEST(Program, ListsAndDescribesMethods) {
  EXPECT_THAT(run_mapbed({"list", "methods"}).out, HasSubstr("odometry"));
  EXPECT_THAT(run_mapbed({"describe", "odometry"}).out, HasSubstr("longest_gap: 1 s  # "));
  EXPECT_THAT(run_mapbed({"describe", "map"}).out, HasSubstr("resolution: 0.05 m  # "));
}

TEST(Program, TellsWhatSensorsAndRobotsPromiseALineEach) {
  const std::string sensors = run_mapbed({"list", "sensors", "--about"}).out;
  EXPECT_THAT(sensors,
              HasSubstr("0.5 to 20 m, 270 deg in 541 beams of 0.5 deg, 50 Hz, sigma 12 mm"));
  EXPECT_THAT(sensors, HasSubstr("; source: SICK support"));
  EXPECT_THAT(sensors, Not(HasSubstr("source: comments of")));  // every file names its own
  EXPECT_THAT(run_mapbed({"describe", "sick_lms111"}).out, HasSubstr("; source: SICK support"));
  EXPECT_THAT(run_mapbed({"describe", "youbot"}).out, HasSubstr("from the data sheet, not opened"));
  EXPECT_THAT(run_mapbed({"list", "robots", "--about"}).out, HasSubstr("omni, 0.8 m/s"));
  EXPECT_THAT(run_mapbed({"list", "sensors"}).out, Not(HasSubstr("source:")));
}

class Evaluate : public CommandTest {
 protected:
  Evaluate() {
    // Straight ahead at 1 m/s; in the second file the robot stood still first, by its odometry.
    write("estimate.tum", "0 0 0 0 0 0 0 1\n10 10 0 0 0 0 0 1\n");
    write("odometry.txt", "# t x y theta\n0 0 0 0\n5 0 0 0\n10 8 0 0\n");
    // Until t = 5: 5 m linearly, 1 m by odometry from both sides. Turned by 0.1 rad.
    write("some.relations", "0 5 1 0 0 0 0 0.1\n0 99 1 0 0 0 0 0\n");
    write("truth.txt", "0 1 0 0\n10 11 0 0\n");
  }
};

TEST_F(Evaluate, PrintsTheRelationsMetricWithAndWithoutOdometry) {
  const std::vector<std::string> linearly{"evaluate", path("estimate.tum"), "--relations",
                                          path("some.relations")};
  const Outcome outcome = run_mapbed(linearly);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1 compared, 1 skipped"));
  EXPECT_THAT(outcome.out, HasSubstr("mean 4.000000 m, std 0.000000 m"));
  EXPECT_THAT(outcome.out, HasSubstr("mean 5.729578 deg"));  // 0.1 rad

  std::vector<std::string> by_odometry = linearly;
  by_odometry.insert(by_odometry.end(), {"--odometry", path("odometry.txt")});
  EXPECT_THAT(run_mapbed(by_odometry).out, HasSubstr("mean 0.000000 m, std 0.000000 m"));
}

TEST_F(Evaluate, TakesTheOdometryOfALog) {
  std::string scan = "FLASER 180";
  for (int beam = 0; beam < 180; ++beam) scan += " 1.0";
  write("log.clf", scan + " 0 0 0 0 0 0 0 host 0\n" + scan + " 0 0 0 0 0 0 5 host 5\n" + scan +
                       " 8 0 0 8 0 0 10 host 10\n");
  const Outcome outcome = run_mapbed({"evaluate", path("estimate.tum"), "--relations",
                                      path("some.relations"), "--odometry", path("log.clf")});
  EXPECT_THAT(outcome.out, HasSubstr("mean 0.000000 m, std 0.000000 m")) << outcome.err;
}

TEST_F(Evaluate, PrintsErrorsAgainstTruthAndWritesThemAll) {
  const Outcome outcome =
      run_mapbed({"evaluate", path("estimate.tum"), "--truth", path("truth.txt"), "--relations",
                  path("some.relations"), "--json", path("errors.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 of 2 true poses"));
  EXPECT_THAT(outcome.out, HasSubstr("error over 5 m of path: 1 comparison\n"));
  const std::string json = read_text_file(path("errors.json"));
  EXPECT_THAT(json, HasSubstr("\"mean_translation_m\": 4.0"));
  EXPECT_THAT(json, HasSubstr("\"skipped\": 1"));
  EXPECT_THAT(json, HasSubstr("\"over_path\""));
}

// At 0 and 10 s there is truth; at -1 and 11 there is none yet or any more, at 5 it has a gap.
TEST_F(Evaluate, TellsOfPosesThatHaveNoTruth) {
  write("longer.txt", "-1 0 0 0\n0 0 0 0\n5 5 0 0\n10 10 0 0\n11 11 0 0\n");
  const auto against = [&](const char* truth) {
    return run_mapbed({"evaluate", path("longer.txt"), "--truth", path(truth), "--json",
                       path("errors.json")})
        .out;
  };
  EXPECT_THAT(against("truth.txt"),
              HasSubstr("truth: 2 of 2 true poses have an estimate within 0.01 s\n"
                        "estimate: 2 of 5 poses have a true one; 3 are not compared: 2 before or "
                        "after all truth, 1 between true poses\n"));
  const std::string json = read_text_file(path("errors.json"));
  EXPECT_THAT(json, HasSubstr("\"estimated_poses\": 5"));
  EXPECT_THAT(json, HasSubstr("\"estimated_poses_with_truth\": 2"));
  EXPECT_THAT(json, HasSubstr("\"estimated_poses_outside_truth\": 2"));
  EXPECT_THAT(against("longer.txt"), HasSubstr("\nestimate: 5 of 5 poses have a true one\n"));
}

TEST_F(Evaluate, ReplacesItsOwnFiguresAndNoOthers) {
  const auto into = [&](const std::string& file) {
    return run_mapbed({"evaluate", path("estimate.tum"), "--relations", path("some.relations"),
                       "-o", path(file)});
  };
  EXPECT_EQ(into("own.json").status, 0);
  EXPECT_EQ(into("own.json").status, 0);
  for (const char* content : {"my own words\n", "{}\n", "{\"relations\": {}, \"mine\": 1}\n"}) {
    write("foreign.json", content);
    expect_refused(into("foreign.json"), "foreign.json: was not written by mapbed");
    EXPECT_EQ(read_text_file(path("foreign.json")), content);
  }
}

TEST_F(Evaluate, SaysWhatIsWrongWithItsFiles) {
  const std::string estimate = path("estimate.tum");
  const std::string relations = path("some.relations");
  write("empty", "");
  write("broken", "0 5 1 0 0 0\n");
  write("words", "once upon a time\n");
  write("late", "1000 1005 1 0 0 0 0 0\n");
  expect_refusal({"evaluate", estimate}, "give --relations or --truth");
  expect_refusal({"evaluate", path("absent"), "--relations", relations}, "absent: no such file");
  expect_refusal({"evaluate", estimate, "--relations", path()}, "is a folder");
  expect_refusal({"evaluate", path("empty"), "--relations", relations}, "empty");
  expect_refusal({"evaluate", path("words"), "--relations", relations}, "words:1: ");
  expect_refusal({"evaluate", estimate, "--relations", path("empty")}, "holds no relation");
  expect_refusal({"evaluate", estimate, "--relations", path("broken")}, "broken:1: a relation has");
  expect_refusal({"evaluate", estimate, "--relations", path("late")},
                 "all 1 relations lie more than 5 s outside the estimate");
  expect_refusal({"evaluate", estimate, "--truth", path("late")},
                 "late:1: the quaternion has length 0");
  expect_refusal({"evaluate", estimate, "--odometry", path("odometry.txt")},
                 "--odometry requires --relations");
  expect_refusal({"evaluate", estimate, "--relations", relations, "--json", "/dev/null/x"},
                 "/dev/null/x");
}

TEST_F(Evaluate, RefusesOptionsThatMakeNoSense) {
  const std::vector<std::string> start{"evaluate", path("estimate.tum"), "--truth",
                                       path("truth.txt")};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), start.begin(), start.end());
    return more;
  };
  expect_refusal(with({"--delta", "0"}), "--delta");
  expect_refusal(with({"--delta", "2.5"}), "whole frames");
  expect_refusal(with({"--delta", "nan", "--delta-unit", "m"}), "--delta");
  expect_refusal(with({"--path-length", "-1"}), "--path-length");
  expect_refusal(with({"--max-time-difference", "soon"}), "--max-time-difference");
  expect_refusal(with({"--delta-unit", "miles"}), "--delta-unit");
}

// The public figures of the sample logs: relations of Kuemmerle et al. and the poses beside them.
TEST(EvaluateRecordedLogs, AgreesWithAnIndependentEvaluator) {
  const char* data = std::getenv("MAPBED_DATA");
  if (data == nullptr) GTEST_SKIP() << "MAPBED_DATA names no folder of logs";
  const std::string intel = std::string(data) + "/intel/intel";
  const std::string fr079 = std::string(data) + "/fr079/fr079";
  const std::string intel_poses = intel + "_gfs_reference_poses.txt.gz";
  const std::string intel_odometry = intel + "_odometry.txt.gz";
  const std::string intel_relations = intel + ".relations.gz";

  const std::string linear =
      run_mapbed({"evaluate", intel_poses, "--relations", intel_relations}).out;
  EXPECT_THAT(linear, HasSubstr("2984 compared, 0 skipped"));
  EXPECT_THAT(linear, HasSubstr("mean 0.126377 m, std 0.117525 m"));
  EXPECT_THAT(linear, HasSubstr("mean 4.155088 deg"));
  const std::string by_odometry = run_mapbed({"evaluate", intel_poses, "--relations",
                                              intel_relations, "--odometry", intel_odometry})
                                      .out;
  EXPECT_THAT(by_odometry, HasSubstr("mean 0.055552 m, std 0.066759 m"));
  EXPECT_THAT(by_odometry, HasSubstr("mean 1.709463 deg"));
  const std::string of_odometry =
      run_mapbed({"evaluate", intel_odometry, "--relations", intel_relations}).out;
  EXPECT_THAT(of_odometry, HasSubstr("mean 7.387035 m, std 14.340084 m"));
  EXPECT_THAT(of_odometry, HasSubstr("mean 39.459143 deg"));
  const std::string freiburg = run_mapbed({"evaluate", fr079 + "_gfs_reference_poses.txt.gz",
                                           "--relations", fr079 + ".relations.gz"})
                                   .out;
  EXPECT_THAT(freiburg, HasSubstr("1685 compared, 0 skipped"));
  EXPECT_THAT(freiburg, HasSubstr("mean 0.059631 m, std 0.041552 m"));
  EXPECT_THAT(freiburg, HasSubstr("mean 0.905502 deg"));
}

}  // namespace
}  // namespace mapbed
