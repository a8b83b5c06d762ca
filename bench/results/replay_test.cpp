#include "bench/results/replay.h"

#include <numbers>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;

constexpr double kStamp = 1'234'567'890.0;  // [s] as large as those of real logs

LaserScan scan_at(double time, std::vector<double> ranges) {
  return {.time = time,
          .robot_from_laser = {.planar = {0.1, 0.0, 0.0}},
          .first_bearing = 0.0,
          .bearing_step = std::numbers::pi / 2,
          .max_range = 8.0,
          .ranges = std::move(ranges)};
}

TEST(Replay, CountsTimeFromTheStartAndRoundsToWhatCanBeSeen) {
  const Replay replay{.title = "run 0",
                      .truth = {{kStamp, {0, 0, 0}}, {kStamp + 2.5, {1.23456, 0, 0.12345}}}};
  const json read = json::parse(replay_json(replay));
  EXPECT_EQ(read["title"], "run 0");
  EXPECT_EQ(read["end"], 2.5);
  EXPECT_THAT(read["truth"]["t"].get<std::vector<double>>(), ElementsAre(0.0, 2.5));
  EXPECT_THAT(read["truth"]["x"].get<std::vector<double>>(), ElementsAre(0.0, 1.23));
  EXPECT_THAT(read["truth"]["a"].get<std::vector<double>>(), ElementsAre(0.0, 0.123));
  EXPECT_FALSE(read.contains("estimate"));
}

TEST(Replay, ScansAreTheirRangesWhereTheyHit) {
  // Ahead 1 m, to the left nothing, behind a failed beam, to the right 2 m.
  const Replay replay{.scans = {scan_at(kStamp, {1.0, 8.0, 0.0, 2.0})}};
  const json scan = json::parse(replay_json(replay))["scans"][0];
  EXPECT_THAT(scan["cm"].get<std::vector<int>>(), ElementsAre(100, 0, 0, 200));
  EXPECT_THAT(scan["laser"].get<std::vector<double>>(), ElementsAre(0.1, 0.0, 0.0));
}

TEST(Replay, BeamsThatAreLeftOutWidenTheStep) {
  const Replay replay{.scans = {scan_at(kStamp, {1.0, 1.5, 2.0, 2.5, 3.0})}};
  const json scan = json::parse(replay_json(replay, {.max_beams = 2}))["scans"][0];
  EXPECT_THAT(scan["cm"].get<std::vector<int>>(), ElementsAre(100, 250));
  EXPECT_NEAR(scan["step"].get<double>(), 3 * std::numbers::pi / 2, 1e-6);
}

TEST(Replay, TellsOfTheBeamsThatAreKeptWhichAreCalledDynamic) {
  Replay replay{.scans = {scan_at(kStamp, {1.0, 1.5, 2.0, 2.5, 3.0}), scan_at(kStamp + 1, {1.0})}};
  replay.labels = {{kStamp, 0, {0.9F, 0.2F, 0.3F, kNoLabel, 0.1F}},
                   {kStamp + 1, 1, {0.1F}}};  // of another laser
  const json read = json::parse(replay_json(replay, {.max_beams = 3}));
  ASSERT_EQ(read["labels"].size(), 2u) << "one for each scan";
  EXPECT_THAT(read["labels"][0].get<std::vector<int>>(), ElementsAre(1, 2)) << "beams 2 and 4";
  EXPECT_EQ(read["labels"][1].size(), 0u);
}

TEST(Replay, LabelsOfAnotherNumberOfBeamsTellNothing) {
  const Replay replay{.scans = {scan_at(kStamp, {1.0, 1.5})}, .labels = {{kStamp, 0, {0.1F}}}};
  EXPECT_EQ(json::parse(replay_json(replay))["labels"][0].size(), 0u);
  EXPECT_FALSE(json::parse(replay_json(Replay{.scans = replay.scans})).contains("labels"));
}

TEST(Replay, FollowsPeopleWithHowSurelyAndWhetherTheyAreSeen) {
  Replay replay{.truth = {{kStamp, {}}}};
  Eigen::Matrix2d along_y;
  along_y << 0.01, 0.0, 0.0, 0.25;
  replay.tracks = {
      {7, {{kStamp, {1.0, 2.0}, {}, along_y, false}, {kStamp + 0.5, {3, 4}, {}, along_y, true}}}};
  replay.tracks[0].states[1].covariance.setZero();
  const json track = json::parse(replay_json(replay))["tracks"][0];
  EXPECT_EQ(track["id"], 7);
  EXPECT_THAT(track["t"].get<std::vector<double>>(), ElementsAre(0.0, 0.5));
  EXPECT_THAT(track["y"].get<std::vector<double>>(), ElementsAre(2.0, 4.0));
  EXPECT_THAT(track["s"].get<std::vector<double>>(), ElementsAre(0.5, 0.0)) << "the longer axis";
  EXPECT_THAT(track["hidden"].get<std::vector<int>>(), ElementsAre(0, 1));
}

TEST(Replay, TracksGoToAnotherFrameWithTheirVelocitiesAndCovariances) {
  Eigen::Matrix2d along_x = Eigen::Vector2d(4.0, 1.0).asDiagonal();
  const Tracks tracks{{1, {{0.0, {1.0, 0.0}, {1.0, 0.0}, along_x, false}}}};
  const TrackState state = transformed(tracks, {10.0, 0.0, std::numbers::pi / 2})[0].states[0];
  EXPECT_NEAR((state.position - Eigen::Vector2d(10.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((state.velocity - Eigen::Vector2d(0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(state.covariance(1, 1), 4.0, 1e-12);
  EXPECT_NEAR(state.covariance(0, 0), 1.0, 1e-12);
}

TEST(Replay, LongRunsAreThinnedButKeepTheirEnds) {
  Replay replay;
  for (int i = 0; i < 1000; ++i) {
    replay.truth.push_back({0.1 * i, {0.01 * i, 0, 0}});
    replay.scans.push_back(scan_at(0.1 * i, std::vector<double>(1000, 1.0)));
  }
  const json read =
      json::parse(replay_json(replay, {.max_steps = 10, .max_scans = 5, .max_beams = 4}));
  ASSERT_EQ(read["truth"]["t"].size(), 10u);
  EXPECT_EQ(read["truth"]["t"][9], 99.9);
  ASSERT_EQ(read["scans"].size(), 5u);
  EXPECT_EQ(read["scans"][4]["t"], 99.9);
  EXPECT_EQ(read["scans"][0]["cm"].size(), 4u);
}

TEST(Replay, OfNothingIsStillOne) {
  EXPECT_EQ(json::parse(replay_json(Replay{}))["end"], 0.0);
  const Replay bad_name{.others = {{"\xFF", "person", 0.25, {{0.0, {}}}}}};
  EXPECT_NO_THROW(json::parse(replay_json(bad_name)));
}

TEST(Replay, KnowsPeopleAndDoorsOfTheTruthButNotTheRobot) {
  Truth truth;
  truth.entities = {{.id = 0, .name = "wall", .kind = EntityKind::structure},
                    {.id = 1, .name = "anna", .kind = EntityKind::person},
                    {.id = 2, .name = "b21r", .kind = EntityKind::robot}};
  const Pose3 leg = upright({1.9, 3.0, 0.0}, 0.4);
  truth.states = {{1.0, {}, {{1, 0, leg}, {1, 1, upright({2, 3, 0}, 1.3)}}},
                  {2.0, {}, {{1, 0, leg}, {1, 1, upright({4, 3, 0}, 1.3)}}}};
  const Replay replay = replay_of(truth, {scan_at(1.0, {1.0})});
  ASSERT_EQ(replay.others.size(), 1u);
  EXPECT_EQ(replay.others[0].name, "anna");
  EXPECT_EQ(replay.others[0].kind, "person");
  ASSERT_EQ(replay.others[0].world_from_it.size(), 2u);
  EXPECT_EQ(replay.others[0].world_from_it[1].pose.position(), Eigen::Vector2d(4, 3))
      << "the trunk";
  EXPECT_EQ(replay.scans.size(), 1u);
}

TEST(Replay, OutlinesAreOfWhatStandsStillAtThatHeight) {
  World world;
  world.entities = {
      {.name = "column", .parts = {{.geometry = Cylinder{0.5, 2.0}}}},
      {.name = "box", .parts = {{.geometry = Box{{1.0, 2.0, 1.0}}}}},
      {.name = "door", .kind = EntityKind::door, .parts = {{.geometry = Box{{1.0, 0.1, 1.0}}}}}};
  const auto outlines = outlines_of(world, 0.3);
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_EQ(outlines[1].size(), 5u) << "four corners, and the first again";
  EXPECT_EQ(outlines[1].front(), outlines[1].back());
  EXPECT_EQ(outlines_of(world, 0.8).size(), 1u) << "the box ends at 0.5 m";
}

TEST(Replay, AnEstimateIsMovedOntoTheTruthAtItsStart) {
  const Trajectory truth{{0.0, {1, 2, std::numbers::pi / 2}}, {1.0, {1, 3, std::numbers::pi / 2}}};
  const Trajectory estimate{{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}};
  const Trajectory moved = aligned_at_start(estimate, truth);
  EXPECT_THAT(moved[0].pose, IsNear(truth[0].pose, Tolerance{1e-12, 1e-12}));
  EXPECT_THAT(moved[1].pose, IsNear(truth[1].pose, Tolerance{1e-12, 1e-12}));
}

}  // namespace
}  // namespace mapbed
