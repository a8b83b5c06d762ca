// `mapbed localize` from the command line to the files that it writes.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>

#include "algorithms/grid/map_file.h"
#include "algorithms/grid/wall_map.h"
#include "bench/cli/testing/command_test.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/samples.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

class LocalizeCommand : public CommandTest {
 protected:
  LocalizeCommand() {
    TestRoom room = rectangular_room(8.0, 5.0);
    room.add_box({-2.0, 1.8}, 1.5, 0.8);
    room.add_box({3.0, -1.0}, 0.8, 1.6);
    DriveOptions drive;
    drive.laser.beams = 180;
    drive.laser.max_range = 80.0;
    const RecordedLog mapping =
        drive_through(room, {{-3.0, -1.0}, {1.5, -1.0}, {1.5, 1.0}, {-0.5, 0.5}}, drive, Rng(1));
    write_map(path("map"), wall_map(mapping.measurements, mapping.true_poses));
    log_ = drive_through(room, {{1.0, 0.0}, {-2.0, 0.0}, {-2.0, -1.5}}, drive, Rng(2));
    write_carmen_log(path("room.log"), log_);
  }

  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"localize", "room.log", "--map", "map.yaml"});
    return call(arguments);
  }

  RecordedLog log_;
};

TEST_F(LocalizeCommand, FindsTheRobotFromAnywhereAndWritesItsPathBesideTheCaller) {
  const Outcome outcome = run({});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("known from"), HasSubstr("room_localized")));
  const Trajectory path_found = load_trajectory(path("room_localized/trajectory.tum"));
  ASSERT_EQ(path_found.size(), log_.true_poses.size());
  EXPECT_THAT(path_found.back().pose, IsNear(log_.true_poses.back().pose, {0.15, 0.05}));
  EXPECT_GT(read_samples(path("room_localized/picture.png")).height, 100);
  EXPECT_THAT(text("room_localized/summary.json"),
              AllOf(HasSubstr("\"complete\": true"), HasSubstr("\"times_lost\": 0")));
  EXPECT_THAT(text("room_localized/known.csv"), HasSubstr("time [s],known,sigma_x [m]"));
}

TEST_F(LocalizeCommand, FollowsTheRobotFromAStart) {
  const Outcome outcome = run({"--start", "1 m, 0 m, 180 deg"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("known from 0.0 s on, lost 0 times after that"));
}

TEST_F(LocalizeCommand, AConfigurationThatWasWrittenRepeatsTheRun) {
  ASSERT_EQ(run({"--seed", "5", "--set", "localization.particles.most=3000", "-o", "a"}).status, 0);
  ASSERT_EQ(run({"--config", "a/config.yaml", "-o", "b"}).status, 0);
  EXPECT_EQ(text("a/trajectory.tum"), text("b/trajectory.tum"));
  EXPECT_EQ(text("a/config.yaml"), text("b/config.yaml"));
}

TEST_F(LocalizeCommand, APeopleFilterMayStandInFront) {
  const Outcome outcome = run({"--people-filter", "people"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(text("room_localized/config.yaml"), HasSubstr("people_filter"));
}

// x to the right, y up, as in the map; a quarter turn about the origin.
TEST_F(LocalizeCommand, MapsMayBeTurned) {
  MapServerMap map = read_map_server(path("map.yaml"));
  const Pose2 turned_from_map{0.0, 0.0, kPi / 6};
  map.map_from_image = turned_from_map * map.map_from_image;
  write_map_server(path("turned"), map);
  const Outcome outcome = call({"localize", "room.log", "--map", "turned.yaml"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(load_trajectory(path("room_localized/trajectory.tum")).back().pose,
              IsNear(turned_from_map * log_.true_poses.back().pose, {0.2, 0.06}));
}

TEST_F(LocalizeCommand, RefusesAStartWhereNoRobotCanBe) {
  expect_refused(run({"--start", "50 m, 0 m, 0"}), "is outside the map");
  expect_refused(run({"--start", "0 m, -2.5 m, 0"}), "is in a wall");
  expect_refused(run({"--start", "1 m, 2 m"}), "is not x, y and heading");
  expect_refused(run({"--start", "1, 2, 0"}), "1");
  EXPECT_FALSE(fs::exists(path("room_localized")));
}

TEST_F(LocalizeCommand, RefusesMapsThatSayNothingAndMethodsThatMakeThem) {
  expect_refusal({"localize", "room.log", "--map", "none.yaml"}, "none.yaml");
  write("broken.yaml", "image: nothing.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
  expect_refusal({"localize", "room.log", "--map", "broken.yaml"}, "nothing.pgm");
  OccupancyMap walls(0.05), ground(0.05);
  for (int x = 0; x < 50; ++x) walls.at({x, 0}) = known(1.0);
  for (int x = 0; x < 50; ++x) ground.at({x, 0}) = known(0.0);
  write_map(path("walls"), walls);
  write_map(path("ground"), ground);
  expect_refusal({"localize", "room.log", "--map", "walls.yaml"}, "nothing of the map is free");
  expect_refusal({"localize", "room.log", "--map", "ground.yaml"},
                 "nothing of the map is occupied");
  expect_refusal({"map", "room.log", "--method", "localization"}, "mapbed localize LOG --map");
}

TEST_F(LocalizeCommand, RefusesAFolderThatHoldsSomethingElse) {
  fs::create_directory(path("other"));
  write("other/picture.png", "mine");
  expect_refused(run({"-o", "other"}), "picture.png");
}

// Four tags in the room's corners, heard by an antenna that looks ahead, once a second.
class LocalizeByTags : public LocalizeCommand {
 protected:
  LocalizeByTags() {
    write_file("tags.csv", "tag,x,y\nsw,-3.9,-2.4\nse,3.9,-2.4\nne,3.9,2.4\nnw,-3.9,2.4\n");
    const std::vector<std::pair<std::string, Eigen::Vector2d>> tags{
        {"sw", {-3.9, -2.4}}, {"se", {3.9, -2.4}}, {"ne", {3.9, 2.4}}, {"nw", {-3.9, 2.4}}};
    RecordedLog log;
    for (const Stamped<Pose2>& pose : log_.true_poses) {
      RfidDetections round{.time = pose.time, .robot_from_antenna = {}, .reads = {}};
      for (const auto& [name, place] : tags) {
        const Eigen::Vector2d seen = inverse(pose.pose) * place;
        const bool ahead = std::abs(std::atan2(seen.y(), seen.x())) < 0.7;
        if (ahead && seen.norm() < 5.0) round.reads.push_back({name, -50.0, 1.0});
      }
      rounds_.emplace_back(round);
    }
  }

  void write_file(const std::string& name, const std::string& text) const {
    write_text_file(path(name), text);
  }
  // The log with the rounds, with or without its scans.
  void write_log(bool with_scans) {
    RecordedLog log = log_;
    if (!with_scans) {
      std::erase_if(log.measurements,
                    [](const Measurement& m) { return std::holds_alternative<LaserScan>(m); });
    }
    log.measurements.insert(log.measurements.end(), rounds_.begin(), rounds_.end());
    std::stable_sort(log.measurements.begin(), log.measurements.end(),
                     [](const auto& a, const auto& b) { return time_of(a) < time_of(b); });
    write_carmen_log(path("room.log"), log);
  }

  SensorLog rounds_;
};

TEST_F(LocalizeByTags, TagsAreOfHelpBesideTheLaserAndAloneGiveAPath) {
  write_log(true);
  const Outcome both = run({"--tags", "tags.csv", "-o", "both"});
  ASSERT_EQ(both.status, 0) << both.err;
  EXPECT_THAT(load_trajectory(path("both/trajectory.tum")).back().pose,
              IsNear(log_.true_poses.back().pose, {0.15, 0.05}));
  EXPECT_THAT(text("both/summary.json"), HasSubstr("\"tags\": \"tags.csv\""));
  write_log(false);
  const Outcome alone = run({"--tags", "tags.csv", "-o", "alone"});
  ASSERT_EQ(alone.status, 0) << alone.err;
  EXPECT_EQ(load_trajectory(path("alone/trajectory.tum")).size(), rounds_.size());
}

TEST_F(LocalizeByTags, WhatIsWrongWithTagsIsTold) {
  EXPECT_THAT(run({"--tags", "tags.csv"}).err, HasSubstr("has no round of an RFID reader"));
  write_log(true);
  write_file("far.csv", "tag,x,y\nsw,500,0\n");
  EXPECT_THAT(run({"--tags", "far.csv"}).err, HasSubstr("none of its tags lies on the map"));
  write_file("twice.csv", "tag,x,y\nsw,1,0\nse,1,1\nsw,2,0\n");
  EXPECT_THAT(run({"--tags", "twice.csv"}).err, HasSubstr("twice.csv:4: tag 'sw' comes a second"));
  write_file("others.csv", "tag,x,y\nnobody,1,0\n");
  const Outcome strangers = run({"--tags", "others.csv", "-o", "strangers"});
  EXPECT_EQ(strangers.status, 0) << strangers.err;
  EXPECT_THAT(strangers.err, AllOf(HasSubstr("none of the 1 tags of others.csv answers"),
                                   HasSubstr("tags answer that others.csv does not know")));
  write_log(false);
  EXPECT_THAT(run({}).err, HasSubstr("say where its RFID tags are by --tags"));
}

}  // namespace
}  // namespace mapbed
