// `mapbed simulate` from the command line to the log and what stands beside it.

#include <filesystem>

#include <gmock/gmock.h>

#include "bench/cli/testing/command_test.h"
#include "core/log/log_file.h"
#include "sim/truth/truth_file.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

class SimulateCommand : public CommandTest {
 protected:
  void expect_no_log(std::vector<std::string> arguments, const std::string& message) const {
    arguments.insert(arguments.begin(), "simulate");
    arguments.insert(arguments.end(), {"-o", "x.log"});
    expect_refusal(arguments, message);
    EXPECT_FALSE(fs::exists(path("x.log")));
  }
};

// The first ten seconds of a drive among people.
std::vector<std::string> short_drive(const std::string& log) {
  return {"simulate", "--world", "office",
          "--robot",  "pioneer", "--people",
          "3",        "--set",   "recorder.longest=10 s",
          "-o",       log};
}

TEST_F(SimulateCommand, WritesALogWithTruthRelationsAndMap) {
  const Outcome outcome = call(short_drive("a.log.gz"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const RecordedLog log = load_log(path("a.log.gz"));
  EXPECT_EQ(log.true_poses.size(), 50u);  // 5 Hz
  const Truth truth = load_truth(path("a.truth.gz"));
  ASSERT_EQ(truth.states.size(), 50u);
  ASSERT_EQ(truth.beams.size(), 50u);
  EXPECT_EQ(truth.beams[7].beams.size(), 180u);
  for (const char* name : {"a.relations", "a.tum", "a_map.pgm", "a_map.yaml", "a.config.yaml"}) {
    EXPECT_TRUE(fs::exists(path(name))) << name;
  }
  const Outcome map = call({"map", "a.log.gz", "--method", "odometry"});
  EXPECT_EQ(map.status, 0) << map.err;
}

TEST_F(SimulateCommand, WritesRoundsOfAnRfidReaderAndWhatIsBehindThem) {
  std::vector<std::string> drive = short_drive("a.log.gz");
  drive[4] = "pioneer_rfid";
  drive.insert(drive.end(), {"--set", "world.tags=40"});
  const Outcome outcome = call(drive);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const RecordedLog log = load_log(path("a.log.gz"));
  std::size_t rounds = 0, reads = 0;
  for (const Measurement& m : log.measurements) {
    const auto* round = std::get_if<RfidDetections>(&m);
    if (round == nullptr) continue;
    ++rounds;
    reads += round->reads.size();
  }
  EXPECT_EQ(rounds, 91u);  // 2 x 4.5 Hz, and one more at the end
  EXPECT_GT(reads, 20u);
  const Truth truth = load_truth(path("a.truth.gz"));
  EXPECT_EQ(truth.tags.size(), 40u);
  EXPECT_EQ(truth.reads.size(), reads);
  EXPECT_THAT(call({"describe", "a.log.gz"}).out,
              HasSubstr("RFID: 91 rounds, " + std::to_string(reads) + " reads of tags\n"));
  EXPECT_THAT(call({"describe", "a.truth.gz"}).out, HasSubstr("RFID tags: 40, read "));
}

TEST_F(SimulateCommand, RefusesAFormatWithoutRfidBeforeItRecords) {
  for (const char* log : {"x.mcap", "x.bag", "x.rawlog"}) {
    // An hour's drive: it would not be over before the test is.
    expect_refusal({"simulate", "--world", "office", "--robot", "pioneer_rfid", "--path",
                    "tag_tour", "--set", "driver.speed=0.2 m/s", "-o", log},
                   "cannot say what they hear; write a CARMEN log, as x.log");
    EXPECT_FALSE(fs::exists(path(log)));
  }
}

TEST_F(SimulateCommand, WritesBagsOfEachKindThatGiveTheSameTrajectory) {
  std::vector<std::string> ros2 = short_drive("c");
  ros2.insert(ros2.end(), {"--format", "ros2"});
  for (const auto& command : {short_drive("a.bag"), short_drive("b.mcap"), ros2}) {
    const Outcome outcome = call(command);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  ASSERT_EQ(call(ros2).status, 0) << "its own files are replaced";
  EXPECT_EQ(load_log(path("b.mcap")).true_poses.size(), 50u);
  for (const char* log : {"a.bag", "b.mcap", "c"}) {
    const Outcome map = call({"map", log});
    ASSERT_EQ(map.status, 0) << map.err;
  }
  EXPECT_EQ(text("a_map/trajectory.tum"), text("b_map/trajectory.tum"));
  EXPECT_EQ(text("a_map/trajectory.tum"), text("c_map/trajectory.tum"));
  const Outcome described = call({"describe", "c"});
  EXPECT_THAT(described.out, HasSubstr("  - /scan: 50 sensor_msgs/LaserScan\n"));
  EXPECT_THAT(described.out, HasSubstr("front laser: 180 beams"));
}

TEST_F(SimulateCommand, PutsNoBagIntoAFolderOfSomebodyElse) {
  fs::create_directory(path("mine"));
  write("mine/notes.txt", "of my own\n");
  std::vector<std::string> ros2 = short_drive("mine");
  ros2.insert(ros2.end(), {"--format", "ros2"});
  expect_refusal(ros2, "notes.txt: was not written by mapbed");
  std::vector<std::string> unknown = short_drive("x.log");
  unknown.insert(unknown.end(), {"--format", "ros3"});
  expect_refusal(unknown, "unknown format of logs 'ros3'; did you mean 'ros1'?");
  expect_refusal(short_drive("x.db3"), "x.db3: is one file of a bag of ROS 2, which is a folder");
}

TEST_F(SimulateCommand, ReplacesItsOwnFilesAndNoOthers) {
  for (const char* name : {"a.tum", "a.config.yaml", "a_map.yaml"}) {
    write(name, "seed: of my own\n");
    expect_refusal(short_drive("a.log"),
                   name + std::string(": was not written by mapbed, and would be written over"));
    EXPECT_EQ(text(name), "seed: of my own\n");
    EXPECT_FALSE(fs::exists(path("a.log")));
    fs::remove(path(name));
  }
  write("a.log", "a recording of my own\n");
  expect_refusal(short_drive("a.log"), "a.log: was not written by mapbed");
  EXPECT_EQ(text("a.log"), "a recording of my own\n");
  fs::remove(path("a.log"));
  fs::create_symlink("b.log", path("a.log"));
  for (const char* once : {"at first", "again"}) {
    EXPECT_EQ(call(short_drive("a.log")).status, 0) << once;
    EXPECT_TRUE(fs::is_symlink(path("a.log")));
    EXPECT_TRUE(fs::exists(path("b.log")));
  }
}

TEST_F(SimulateCommand, TakesTheTruthFromNoLogOfAnotherDrive) {
  const auto drive = [](const std::string& log, const std::string& seed) {
    return std::vector<std::string>{"simulate", "--world", "corridor",
                                    "--robot",  "pioneer", "--people",
                                    "0",        "--set",   "recorder.longest=2 s",
                                    "--seed",   seed,      "-o",
                                    log};
  };
  ASSERT_EQ(call(drive("a.log", "1")).status, 0);
  const std::string truth = text("a.truth.gz");
  expect_refusal(drive("a.mcap", "2"),
                 "a.config.yaml: holds the drive of another log, 'a.log' ('seed: 1', here 'seed: "
                 "2'); a.config.yaml, a.truth.gz, a.tum, a_map.pgm, a_map.yaml would be written "
                 "over; name another log with --out");
  std::vector<std::string> longer = drive("a.mcap", "1");
  longer.insert(longer.end(), {"--set", "recorder.longest=3 s"});
  expect_refusal(longer, "('recorder.longest: 2 s', here 'recorder.longest: 3 s')");
  EXPECT_TRUE(text("a.truth.gz") == truth);
  EXPECT_FALSE(fs::exists(path("a.mcap")));

  std::vector<std::string> folder = drive("a", "1");
  folder.insert(folder.end(), {"--format", "ros2"});
  EXPECT_EQ(call(folder).status, 0) << "the same drive in another format";
  EXPECT_TRUE(text("a.truth.gz") == truth);
  expect_refusal(drive("a.log", "2"), "a.config.yaml: holds the drive of another log, 'a' (");
  fs::remove_all(path("a"));
  EXPECT_EQ(call(drive("a.log", "2")).status, 0) << "its own files are replaced";
  EXPECT_FALSE(text("a.truth.gz") == truth);
}

TEST_F(SimulateCommand, TheSameSeedGivesTheSameBytes) {
  ASSERT_EQ(call(short_drive("a.log")).status, 0);
  ASSERT_EQ(call(short_drive("b.log")).status, 0);
  for (const char* ending : {".log", ".truth.gz", "_map.pgm", ".relations"}) {
    EXPECT_EQ(text(std::string("a") + ending), text(std::string("b") + ending)) << ending;
  }
  std::vector<std::string> other = short_drive("c.log");
  other.insert(other.end(), {"--seed", "2"});
  ASSERT_EQ(call(other).status, 0);
  EXPECT_NE(text("a.log"), text("c.log"));
}

TEST_F(SimulateCommand, RefusesALogThatCannotBeWrittenBeforeItSimulates) {
  // Nothing else is looked at before.
  expect_refusal({"simulate", "--world", "nowhere", "--robot", "pioneer", "-o", "no/a.log"},
                 "no/a.log: cannot be written: No such file or directory");
  expect_refusal({"simulate", "--world", "nowhere", "--robot", "pioneer", "-o", "."},
                 "is a folder");
}

TEST_F(SimulateCommand, IntoAPipeGoesTheLogAlone) {
  ASSERT_EQ(call(short_drive("a.log")).status, 0);
  const Outcome outcome = run_shell(
      "$MAPBED simulate --world office --robot pioneer --people 3 --set recorder.longest='10 s' "
      "-o /dev/stdout | cat",
      path());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, text("a.log"));
  EXPECT_THAT(outcome.err, HasSubstr("written to /dev/stdout\n"));
  EXPECT_FALSE(fs::exists("/dev/stdout.tum"));
  const Outcome redirected = run_shell(
      "$MAPBED simulate --world office --robot pioneer --people 3 --set recorder.longest='10 s' "
      "-o /dev/stdout >>kept.log 2>words; cat kept.log",
      path());
  EXPECT_EQ(redirected.out, text("a.log"));
}

TEST_F(SimulateCommand, TakesAScenario) {
  write("drive.yaml",
        "world: office\nrobot: b21r\npath: ring\npeople: 0\n"
        "set: {recorder: {longest: 2 s}}\n");
  const Outcome outcome = call({"simulate", "drive.yaml", "-o", "a.log"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("b21r in office"));
}

TEST_F(SimulateCommand, TheConfigurationBesideALogGivesItAgain) {
  write("room.yaml", "start: corridor\noptions: {length: 14 m}\n");
  const Outcome first =
      call({"simulate", "--world", "./room.yaml", "--robot", "pioneer", "--people", "2", "--seed",
            "7", "--set", "recorder.longest=2 s", "-o", "a.log"});
  ASSERT_EQ(first.status, 0) << first.err;
  fs::create_directory(path("inner"));
  fs::rename(path("a.config.yaml"), path("inner/a.config.yaml"));
  const Outcome again = call({"simulate", "inner/a.config.yaml", "-o", "b.log"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, ::testing::Not(HasSubstr("changed since")));
  for (const char* ending : {".log", ".truth.gz", "_map.pgm", ".tum"}) {
    EXPECT_EQ(text(std::string("a") + ending), text(std::string("b") + ending)) << ending;
  }
  EXPECT_EQ(text("inner/a.config.yaml"), text("b.config.yaml"));

  write("room.yaml", "start: corridor\noptions: {length: 15 m}\n");
  EXPECT_THAT(call({"simulate", "inner/a.config.yaml", "-o", "c.log"}).err,
              HasSubstr("room.yaml changed since inner/a.config.yaml was written"));
}

TEST_F(SimulateCommand, RefusesWhatItDoesNotKnow) {
  expect_no_log({}, "simulate needs a scenario file, or --world and --robot");
  expect_no_log({"--world", "offize", "--robot", "pioneer"}, "did you mean 'office'?");
  expect_no_log({"--world", "office", "--robot", "pionier"}, "did you mean 'pioneer'?");
  expect_no_log({"--world", "office", "--robot", "pioneer", "--path", "rink"},
                "did you mean 'ring'?");
  expect_no_log({"--world", "office", "--robot", "pioneer", "--set", "robot.drive.fricton=1"},
                "did you mean");
  expect_no_log({"--world", "office", "--robot", "pioneer", "--people", "5000"},
                "the crowd does not fit");
}

}  // namespace
}  // namespace mapbed
