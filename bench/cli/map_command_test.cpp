// `mapbed map` from the command line to the files that it writes.

#include <filesystem>

#include <gmock/gmock.h>
#include <unistd.h>

#include "bench/cli/testing/command_test.h"
#include "core/file/hash.h"
#include "core/geometry/tum_file.h"
#include "core/image/samples.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/source_tree.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace fs = std::filesystem;

class MapCommand : public CommandTest {
 protected:
  MapCommand() {
    DriveOptions drive;
    drive.laser.beams = 180;
    drive.laser.max_range = 80.0;
    log_ = drive_through(rectangular_room(6.0, 4.0), {{-1.0, 0.0}, {1.5, 0.0}}, drive, Rng(1));
    write_carmen_log(path("room.log"), log_);
  }

  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"map", "room.log", "--method", "odometry"});
    return call(arguments);
  }

  RecordedLog log_;
};

TEST_F(MapCommand, WritesMapTrajectoryAndFiguresBesideTheCaller) {
  const Outcome outcome = run({});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("times real time"), HasSubstr("room_map")));
  const Trajectory trajectory = load_trajectory(path("room_map/trajectory.tum"));
  ASSERT_EQ(trajectory.size(), log_.true_poses.size());
  EXPECT_NEAR(trajectory.front().time, log_.true_poses.front().time, 1e-6) << "absolute stamps";
  const Samples map = read_samples(path("room_map/map.png"));
  // What lies before the start, 1 m behind the middle of 6 m x 4 m: 4 m each way at 5 cm. The drive
  // of 2.5 m may turn the map by some 0.06 rad (two sigma), which moves its corners by 5 cells.
  EXPECT_NEAR(map.width, 4.0 / 0.05, 6);
  EXPECT_NEAR(map.height, 4.0 / 0.05, 10);
  EXPECT_GT(read_samples(path("room_map/picture.png")).height, map.height);
  EXPECT_THAT(text("room_map/map.yaml"), HasSubstr("resolution: 0.05"));
  EXPECT_TRUE(fs::exists(path("room_map/map.pgm")));
  EXPECT_THAT(text("room_map/summary.json"),
              AllOf(HasSubstr("\"complete\": true"), HasSubstr("\"method\": \"odometry\"")));
  EXPECT_THAT(text("room_map/cost.csv"), StartsWith("scans,recorded_s,"));
}

TEST_F(MapCommand, SaysWhereTheLaserLooksAndWhoSaysSo) {
  const std::string laser = "front laser: 180 beams, 1 deg from -90 deg (its lines), at (0 m, ";
  EXPECT_THAT(run({"--out", "a"}).out, HasSubstr(laser));
  EXPECT_THAT(text("a/summary.json"), HasSubstr(laser));
  EXPECT_THAT(run_mapbed({"describe", path("room.log")}).out, HasSubstr(laser));
}

TEST_F(MapCommand, WritesClosedWallsForMapServersOrTheModelsValues) {
  ASSERT_EQ(run({"--out", "a"}).status, 0);
  EXPECT_THAT(text("a/map.yaml"), HasSubstr("mode: trinary"));
  ASSERT_EQ(run({"--out", "b", "--set", "map_file=graded"}).status, 0);
  EXPECT_THAT(text("b/map.yaml"), HasSubstr("mode: raw"));
  EXPECT_EQ(text("a/trajectory.tum"), text("b/trajectory.tum"));
}

TEST_F(MapCommand, TellsWhichLogItIsOf) {
  ASSERT_EQ(run({"--out", "a"}).status, 0);
  EXPECT_THAT(text("a/summary.json"),
              HasSubstr("\"log_sha256\": \"" + sha256_of_file(path("room.log")) + "\""));
}

TEST_F(MapCommand, TheSameCommandGivesTheSameBytes) {
  ASSERT_EQ(run({"--out", "a"}).status, 0);
  ASSERT_EQ(run({"--out", "b"}).status, 0);
  for (const fs::directory_entry& file : fs::directory_iterator(path("a"))) {
    const std::string name = file.path().filename();
    if (name == "cost.csv") continue;  // time and memory, which stand nowhere else
    EXPECT_EQ(text("a/" + name), text("b/" + name)) << name;
  }
}

TEST_F(MapCommand, ItsConfigurationRepeatsTheRun) {
  ASSERT_EQ(run({"--out", "a", "--resolution", "10 cm", "--set", "map.model=odds"}).status, 0);
  EXPECT_THAT(text("a/config.yaml"), AllOf(HasSubstr("resolution: 0.1 m"), HasSubstr("odds")));
  const Outcome again = call({"map", "room.log", "--config", "a/config.yaml", "--out", "b"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(text("a/config.yaml"), text("b/config.yaml"));
  EXPECT_EQ(text("a/map.png"), text("b/map.png"));
}

TEST_F(MapCommand, TakesALogByItsDescriptionOrName) {
  const Outcome by_name = call({"map", "example", "--method", "odometry", "--out", "by_name"});
  ASSERT_EQ(by_name.status, 0) << by_name.err;
  const Outcome by_file = call({"map", source_tree() + "/scenarios/logs/example.yaml", "--method",
                                "odometry", "--out", "by_file"});
  ASSERT_EQ(by_file.status, 0) << by_file.err;
  EXPECT_EQ(text("by_name/map.png"), text("by_file/map.png"));
  expect_refusal({"map", "exampel"}, "did you mean 'example'?");
}

TEST_F(MapCommand, GivesTheSameBytesForAnyNumberOfThreads) {
  for (const char* threads : {"1", "2", "8"}) {
    const Outcome outcome =
        call({"map", "room.log", "--method", "rbpf", "--set", "rbpf.particles=10", "-j", threads,
              "--out", std::string("j") + threads});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(text(std::string("j") + threads + "/trajectory.tum"), text("j1/trajectory.tum"));
  }
  expect_refusal({"map", "room.log", "-j", "0"}, "--threads");
}

TEST_F(MapCommand, LogsWhoseNamesAreAlikeHaveAFolderEach) {
  fs::copy(path("room.log"), path("room.2.log"));
  ASSERT_EQ(call({"map", "room.log", "--method", "odometry"}).status, 0);
  ASSERT_EQ(call({"map", "room.2.log", "--method", "odometry"}).status, 0);
  EXPECT_TRUE(fs::exists(path("room.2_map/summary.json")));
  ASSERT_EQ(call({"map", "./room.log", "--method", "odometry"}).status, 0) << "the same log again";
  fs::create_directory(path("b"));
  fs::copy(path("room.log"), path("b/room.log"));
  expect_refusal({"map", "b/room.log", "--method", "odometry"},
                 "room_map: holds the map of another log, './room.log'; name a folder with --out");
}

TEST_F(MapCommand, RefusesAFolderThatCannotBeWrittenBeforeItReadsTheLog) {
  expect_refusal({"map", "room.log", "--out", "room.log"}, "room.log: ");
  expect_refusal({"map", "absent.log", "--out", "/proc/maps"}, "/proc/maps: cannot be made");
  expect_refusal({"map", "absent.log", "--out", "new/folder"}, "absent.log: no such file");
  EXPECT_FALSE(fs::exists(path("new"))) << "made for nothing";
}

TEST_F(MapCommand, SaysWhatIsWrongWithTheLog) {
  write("empty.log", "");
  write("words.log", "once upon a time\n");
  write("drive.bag", "#ROSBAG V2.0\n");
  expect_refusal({"map", "absent.log"}, "absent.log: ");
  expect_refusal({"map", "."}, "folder");
  expect_refusal({"map", "empty.log"}, "empty.log");
  expect_refusal({"map", "words.log"}, "words.log");
  expect_refusal({"map", "drive.bag"}, "drive.bag");
  EXPECT_FALSE(fs::exists(path("empty_map"))) << "nothing is left of a run that never began";
}

TEST_F(MapCommand, OdometryAloneNeedsALogWithSome) {
  write("scans.log",
        "# angle_min -0.5 angle_increment 0.5 range_max 5\n"
        "1.0 3 2 2 2\n1.1 3 2 2 2\n1.2 3 2 2 2\n");
  expect_refusal({"map", "scans.log", "--method", "odometry"},
                 "scans.log: has no odometry, and odometry has nothing else to go by; choose a "
                 "method that matches scans, with --method");
  EXPECT_FALSE(fs::exists(path("scans_map")));
}

TEST_F(MapCommand, DrawsThePictureThatTheReadmeShows) {
  if (__builtin_cpu_supports("fma") == 0) GTEST_SKIP() << "no fused multiply-add";
  ASSERT_EQ(call({"map", "example"}).status, 0);
  EXPECT_TRUE(text("example_map/picture.png") ==
              read_text_file(source_tree() + "/docs/example.png"))
      << "another picture: copy that of 'mapbed map example' there";
}

// A bare word is a name, also where a file is called so.
TEST_F(MapCommand, AsOtherCommandsAsksForTheFileThatIsCalledLikeAnUnknownName) {
  write("mine.yaml", "about: mine\n");
  write("method.yaml",
        "world: office\nrobot: pioneer\nestimator: mine\n"
        "metrics: [translation_error]\n");
  expect_refusal({"map", "room"}, "unknown log 'room'; did you mean ./room.log?");
  expect_refusal({"describe", "room"}, "there is nothing called 'room'; did you mean ./room.log?");
  const std::string meant = "; did you mean ./mine.yaml?";
  expect_refusal({"run", "mine"}, "unknown scenario 'mine'" + meant);
  expect_refusal({"run", "./method.yaml"}, "unknown method 'mine'" + meant);
  expect_refusal({"render", "mine", "-o", "x.png"}, "unknown world 'mine'" + meant);
  expect_refusal({"map", "room.log", "--method", "mine"}, "unknown method 'mine'" + meant);
  const std::vector<std::string> drive{"simulate", "--world", "office", "-o", "x.log", "--robot"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), drive.begin(), drive.end());
    return more;
  };
  expect_refusal(with({"mine"}), "unknown robot 'mine'" + meant);
  expect_refusal(with({"pioneer", "--set", "robot.front.sensor=mine"}),
                 "unknown sensor 'mine'" + meant);
}

TEST_F(MapCommand, WhatIsNoLogIsToldSo) {
  write("README.md", "# A title\n\nA text that was not recorded.\nWith two lines.\n");
  expect_refusal({"map", "README.md"}, "README.md: is in no log format that is known here; known");
  EXPECT_FALSE(fs::exists(path("README_map")));
}

TEST_F(MapCommand, SaysWhatIsWrongWithItsOptions) {
  write("wrong.yaml", "map:\n  resolutoin: 5 cm\n");
  write("not.yaml", "map: [1, 2\n");
  expect_refusal({"map", "room.log", "--method", "odometri"},
                 "unknown method 'odometri'; did you mean 'odometry'?");
  expect_refusal({"map", "room.log", "--methd", "odometry"}, "did you mean '--method'?");
  expect_refusal({"map", "room.log", "--set", "map.resolution"}, "path=value");
  expect_refusal({"map", "room.log", "--set", "map.resolutoin=5 cm"}, "did you mean 'resolution'?");
  expect_refusal({"map", "room.log", "--resolution", "5 kg"}, "'5 kg' is not a length");
  expect_refusal({"map", "room.log", "--resolution", "0 m"}, "resolution");
  expect_refusal({"map", "room.log", "--resolution", "nan m"}, "nan");
  expect_refusal({"map", "room.log", "--seed", "first"}, "first");
  expect_refusal({"map", "room.log", "--config", "wrong.yaml"}, "wrong.yaml:2: unknown key");
  expect_refusal({"map", "room.log", "--config", "not.yaml"}, "not.yaml:");
  expect_refusal({"map", "room.log", "--config", "absent.yaml"}, "absent.yaml");
}

TEST_F(MapCommand, SaysBeforeTheWorkThatTheFolderWillNotDo) {
  write("file", "x");
  expect_refusal({"map", "room.log", "--out", "file"}, "file: ");
  expect_refusal({"map", "room.log", "--out", "/dev/null/x"}, "choose another folder with --out");
  if (geteuid() != 0) {  // root may write everywhere
    fs::create_directory(path("locked"));
    fs::permissions(path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
    expect_refusal({"map", "room.log", "--out", "locked"}, "cannot be written into");
  }
}

TEST_F(MapCommand, ReplacesItsOwnFilesAndNoOthers) {
  const std::vector<std::string> map{"map", "room.log", "--method", "odometry", "--out", "m"};
  EXPECT_EQ(call({"map", "room.log", "--method", "odometry", "--out", "all"}).status, 0);
  fs::create_directory(path("m"));
  for (const auto& entry : fs::directory_iterator(path("all"))) {
    const std::string name = "m/" + entry.path().filename().string();
    write(name, "{\"log\": \"my own\"}");
    expect_refusal(map, name +
                            ": was not written by mapbed, and would be written over; move it "
                            "away, or choose another folder");
    EXPECT_EQ(text(name), "{\"log\": \"my own\"}");
    fs::remove(path(name));
  }
  EXPECT_TRUE(fs::is_empty(path("m")));
  write("m/notes.txt", "somebody's own");
  EXPECT_EQ(call(map).status, 0);
  EXPECT_EQ(call(map).status, 0);
  EXPECT_EQ(text("m/notes.txt"), "somebody's own");
}

TEST_F(MapCommand, LeavesNoHalfWrittenFileOnAFullDisk) {
  // No file may grow beyond 2 kB, as if the disk were full then.
  const Outcome outcome = run_shell(
      "trap '' XFSZ; ulimit -f 4; exec \"$MAPBED\" map room.log --method odometry --out full",
      path());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("mapbed: full/"));
  EXPECT_FALSE(fs::exists(path("full")));
}

TEST_F(MapCommand, EndsWithItsOwnStatusWhenItIsInterrupted) {
  // As soon as the program catches signal 15, which it does once the log is read.
  const Outcome outcome = run_shell(
      "$MAPBED map example --method rbpf --set rbpf.particles=300 -j 1 --out part & p=$!\n"
      "until grep -Eq '^SigCgt:.*[4-7c-f][0-9a-f]{3}$' /proc/$p/status; do sleep 0.01; done\n"
      "kill -TERM $p; wait $p",
      path());
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("mapbed: interrupted "));
}

}  // namespace
}  // namespace mapbed
