// `mapbed simulate` from the command line to the log and what stands beside it.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <unistd.h>

#include "bench/cli/program_under_test.h"
#include "core/log/log_file.h"
#include "sim/truth.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

class SimulateCommand : public ::testing::Test {
 protected:
  SimulateCommand() {
    folder_ = fs::temp_directory_path() / ("mapbed_simulate_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~SimulateCommand() override { fs::remove_all(folder_); }

  std::string content(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  void expect_refusal(std::vector<std::string> arguments, const std::string& message) const {
    arguments.insert(arguments.begin(), "simulate");
    arguments.insert(arguments.end(), {"-o", "x.log"});
    const Outcome outcome = run_mapbed(arguments, folder_);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder_ / "x.log"));
  }

  fs::path folder_;
};

// The first ten seconds of a drive among people.
std::vector<std::string> short_drive(const std::string& log) {
  return {"simulate", "--world", "office",
          "--robot",  "pioneer", "--people",
          "3",        "--set",   "recorder.longest=10 s",
          "-o",       log};
}

TEST_F(SimulateCommand, WritesALogWithTruthRelationsAndMap) {
  const Outcome outcome = run_mapbed(short_drive("a.log.gz"), folder_);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const RecordedLog log = load_log(folder_ / "a.log.gz");
  EXPECT_EQ(log.true_poses.size(), 50u);  // 5 Hz
  const Truth truth = load_truth(folder_ / "a.truth.gz");
  ASSERT_EQ(truth.scans.size(), 50u);
  EXPECT_EQ(truth.scans[7].beams.size(), 180u);
  for (const char* name : {"a.relations", "a.tum", "a_map.pgm", "a_map.yaml", "a.config.yaml"}) {
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  }
  const Outcome map = run_mapbed({"map", "a.log.gz", "--method", "odometry"}, folder_);
  EXPECT_EQ(map.status, 0) << map.err;
}

TEST_F(SimulateCommand, TheSameSeedGivesTheSameBytes) {
  ASSERT_EQ(run_mapbed(short_drive("a.log"), folder_).status, 0);
  ASSERT_EQ(run_mapbed(short_drive("b.log"), folder_).status, 0);
  for (const char* ending : {".log", ".truth.gz", "_map.pgm", ".relations"}) {
    EXPECT_EQ(content(std::string("a") + ending), content(std::string("b") + ending)) << ending;
  }
  std::vector<std::string> other = short_drive("c.log");
  other.insert(other.end(), {"--seed", "2"});
  ASSERT_EQ(run_mapbed(other, folder_).status, 0);
  EXPECT_NE(content("a.log"), content("c.log"));
}

TEST_F(SimulateCommand, TakesAScenario) {
  std::ofstream(folder_ / "drive.yaml") << "world: office\nrobot: b21r\npath: ring\npeople: 0\n"
                                           "set: {recorder: {longest: 2 s}}\n";
  const Outcome outcome = run_mapbed({"simulate", "drive.yaml", "-o", "a.log"}, folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("b21r in office"));
}

TEST_F(SimulateCommand, RefusesWhatItDoesNotKnow) {
  expect_refusal({}, "simulate needs a scenario file, or --world and --robot");
  expect_refusal({"--world", "offize", "--robot", "pioneer"}, "did you mean 'office'?");
  expect_refusal({"--world", "office", "--robot", "pionier"}, "did you mean 'pioneer'?");
  expect_refusal({"--world", "office", "--robot", "pioneer", "--path", "rink"},
                 "did you mean 'ring'?");
  expect_refusal({"--world", "office", "--robot", "pioneer", "--set", "robot.drive.fricton=1"},
                 "did you mean");
  expect_refusal({"--world", "office", "--robot", "pioneer", "--people", "5000"},
                 "the crowd does not fit");
}

}  // namespace
}  // namespace mapbed
