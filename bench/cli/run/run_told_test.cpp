// What `mapbed run` tells of single runs, of those that failed and of quick ones.

#include <filesystem>

#include <gmock/gmock.h>

#include "algorithms/grid/map_file.h"
#include "bench/cli/testing/command_test.h"
#include "core/geometry/tum_file.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

// 24 runs on 6 recordings of two seconds.
constexpr const char* kDrives =
    "world: office\n"
    "robot: pioneer\n"
    "people: 2\n"
    "recorder.longest: 2 s\n"
    "sweep: {robot.odometry.rotation_sigma: [0 deg, 3 deg]}\n"
    "compare: {raw: {estimator: odometry}, matched: {estimator: scan_matching}}\n"
    "seeds: 6\n"
    "metrics: [largest_error, failures]\n";

class RunTold : public CommandTest {
 protected:
  RunTold() { write("drives.yaml", kDrives); }

  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"run", "./drives.yaml"});
    return call(arguments);
  }
};

TEST_F(RunTold, WritesAllOfOneRunIntoAFolder) {
  ASSERT_EQ(run({"--out", "all"}).status, 0);
  const Outcome outcome = run({"--run", "17", "--out", "one"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(text("all/runs.csv"),
              HasSubstr(text("one/run.csv").substr(text("one/run.csv").find('\n') + 1)));
  for (const char* file : {"one/maps/map.png", "one/maps/map.pgm", "one/maps/map.yaml",
                           "one/trajectories/estimate.tum", "one/config.yaml"}) {
    EXPECT_TRUE(fs::exists(path(file))) << file;
    EXPECT_THAT(outcome.out, HasSubstr(std::string("written: ") + file));
  }
  EXPECT_FALSE(fs::exists(path("all/maps/map.pgm"))) << "of a single run alone";
  const OccupancyMap map = read_map(path("one/maps/map.yaml"));
  const Trajectory drive = load_trajectory(path("one/trajectories/estimate.tum"));
  ASSERT_FALSE(drive.empty());
  int free = 0;
  for (const Stamped<Pose2>& stamped : drive) {
    const Occupancy& cell = map[map.cell_of(stamped.pose.position())];
    EXPECT_LE(cell.probability, 0.0F) << "it drove through no wall";
    free += cell.known() ? 1 : 0;
  }
  EXPECT_GT(free, 0) << "and the map lies in the path's frame";
  EXPECT_EQ(run({"--run", "16", "--out", "one"}).status, 0) << "of its own";
  EXPECT_THAT(text("one/run.csv"), HasSubstr("\n16,"));
  fs::remove(path("one/run.csv"));
  EXPECT_THAT(run({"--run", "16", "--out", "one"}).err, HasSubstr("was not written by mapbed"));
  EXPECT_THAT(run({"--run", "16", "--out", "all"}).err,
              HasSubstr("holds the results of a scenario"));
}

TEST_F(RunTold, TellsWhatFailedRunsAre) {
  const Outcome outcome =
      run({"--set", "seeds=2", "--set", "failure_distance=0.1 mm", "--out", "r"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("failed: these runs did not come to what they should"));
  EXPECT_THAT(outcome.out, HasSubstr("r/runs.csv, column failure"));
}

TEST_F(RunTold, AQuickRunThatMayJudgeGivesNoVerdictEither) {
  write("no.yaml",
        "base: drives.yaml\nseeds: 1\nclaims: [{metric: largest_error, below: 0 m}]\n"
        "quick: {levels: 1}\n");
  const Outcome outcome = call({"run", "./no.yaml", "--quick", "--out", "q"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("quick: holds not largest_error"));
  EXPECT_THAT(outcome.out, HasSubstr("a quick run is no verdict"));
  EXPECT_THAT(outcome.out, ::testing::Not(HasSubstr("HELD")));
  const std::string page = text("q/report.html");
  EXPECT_THAT(page, HasSubstr("quick: holds not"));
  EXPECT_THAT(page, ::testing::Not(HasSubstr("not held")));
  ASSERT_EQ(call({"report", "."}).status, 0);
  for (const char* overview : {"report.html", "README.md"}) {
    EXPECT_THAT(text(overview), HasSubstr("quick: holds not")) << overview;
    EXPECT_THAT(text(overview), ::testing::Not(HasSubstr("not held"))) << overview;
  }
}

}  // namespace
}  // namespace mapbed
