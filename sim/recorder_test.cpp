#include "sim/recorder.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/throws_input_error.h"
#include "sim/drivers/scripted_driver.h"
#include "sim/noise/sensor_noise.h"
#include "sim/testing/small_world.h"

namespace mapbed {
namespace {

World room_with_path() {
  World world = small_room(8.0, 5.0);
  world.entities.push_back(block("column", {4.0, 3.0}, {0.4, 0.4}));
  world.paths = {{.name = "round", .points = {{{1.0, 1.0}}, {{6.5, 1.0}}, {{6.5, 4.0}}}}};
  world.crowd.routes = {{.name = "across", .points = {{1.0, 4.0}, {5.5, 4.0}}}};
  world.crowd.places = {{.position = {2.0, 3.0}, .radius = 0.5}};
  return world;
}

Robot small_robot() {
  Robot robot;
  robot.name = "small";
  robot.mass = 20.0;
  robot.height = 0.5;
  robot.footprint.radius = 0.25;
  LaserModel laser;
  laser.beams = 60;
  laser.bearing_step = radians(3.0);
  robot.sensors = {{.name = "front", .robot_from_sensor = {.z = 0.35}, .model = laser}};
  return robot;
}

LaserModel& laser_of(Robot& robot) {
  return std::get<LaserModel>(robot.sensors[0].model);
}

// All readings of one kind.
template <class Kind>
std::vector<Kind> all_of(const Recording& recording) {
  std::vector<Kind> found;
  for (const IdealReading& reading : recording.readings) {
    if (const auto* one = std::get_if<Kind>(&reading)) found.push_back(*one);
  }
  return found;
}

struct Drive {
  Recording recording;
  SensorLog log;
};

Drive recorded(const World& world, const Robot& robot, const CrowdOptions& people,
               std::uint64_t seed, const RecorderOptions& options = {}) {
  const Rng rng(seed);
  Simulation simulation(world, robot, start_of(world.paths[0]), {.actors = {.people = people}},
                        rng);
  ScriptedDriver driver(simulation, world.paths[0]);
  RecorderOptions bounded = options;
  bounded.longest = std::min(bounded.longest, driver.longest_time());
  Recording recording = record(simulation, driver, bounded, rng);
  SensorLog log = with_noise(recording.readings, robot, rng);
  return {std::move(recording), std::move(log)};
}

// Drives ahead whatever there is, and rests when it is told to.
class AlwaysAhead : public Driver {
 public:
  explicit AlwaysAhead(double rests_until = -1.0) : rests_until_(rests_until) {}
  void add(const Measurement& /*measurement*/) override {}
  DriveCommand command(double time) override {
    return {.forward_velocity = is_resting(time) ? 0.0 : 0.5};
  }
  bool is_done() const override { return false; }
  bool is_resting(double time) const override { return time < rests_until_; }

 private:
  double rests_until_;
};

RecordingEnd end_of_drive_into(const Entity& obstacle, Driver& driver, double longest) {
  World world = small_room(8.0, 5.0);
  world.entities.push_back(obstacle);
  Simulation simulation(world, small_robot(), {1.0, 2.5, 0.0}, {}, Rng(1));
  return record(simulation, driver, {.longest = longest, .stuck_after = 10.0}, Rng(1)).end;
}

TEST(Recorder, ARobotThatIsStuckIsToldWhereAndByWhatAndTheRecordingEnds) {
  AlwaysAhead driver;
  const RecordingEnd end = end_of_drive_into(block("crate", {4.0, 2.5}, {1.0, 1.0}), driver, 60.0);
  EXPECT_FALSE(end.is_complete);
  // The crate begins at 3.5 m, the robot reaches 0.25 m: 2.25 m at 0.5 m/s, and 0.5 s to speed up;
  // the last 5 cm do not count.
  EXPECT_THAT(end.stuck,
              ::testing::MatchesRegex(
                  "the robot has stood at \\(3\\.2[0-9] m, 2\\.50 m\\) since (4\\.9|5\\.[0-9]) "
                  "s, stuck by 'crate'"));
}

TEST(Recorder, ARobotThatStandsForNoReasonTouchesNothing) {
  AlwaysAhead driver;  // in 0.2 s it has come no 5 cm far
  Simulation simulation(small_room(8.0, 5.0), small_robot(), {1.0, 2.5, 0.0}, {}, Rng(1));
  EXPECT_THAT(record(simulation, driver, {.stuck_after = 0.2}, Rng(1)).end.stuck,
              ::testing::HasSubstr("though it touches nothing; nearest to it is 'west wall'"));
}

TEST(Recorder, ADriverThatRestsIsNotStuckNorOneWhoseTimeIsOver) {
  AlwaysAhead resting(30.0);
  EXPECT_EQ(end_of_drive_into(block("crate", {4.0, 2.5}, {1.0, 1.0}), resting, 35.0).stuck, "");
  AlwaysAhead driver;
  EXPECT_EQ(end_of_drive_into(block("crate", {4.0, 2.5}, {1.0, 1.0}), driver, 12.0).stuck, "");
}

// Nobody gets past somebody in a corridor of 90 cm, who is pushed to its end.
TEST(Recorder, WhoStandsInTheWayIsToldToo) {
  World world = small_room(6.0, 0.9);
  world.crowd.places = {{.position = {4.0, 0.45}, .radius = 0.01}};
  Simulation simulation(world, small_robot(), {1.0, 0.45, 0.0},
                        {.actors = {.people = {.standing = 1}}}, Rng(3));
  AlwaysAhead driver;
  const RecordingEnd end =
      record(simulation, driver, {.longest = 60.0, .stuck_after = 10.0}, Rng(1)).end;
  EXPECT_THAT(end.stuck, ::testing::HasSubstr("stuck by somebody at ("));
}

// With an antenna to either side.
Robot robot_with_antennas() {
  Robot robot = small_robot();
  RfidModel model;
  model.round_rate = 2.0;
  for (const double side : {0.8, -0.8}) {
    robot.sensors.push_back({.name = side > 0.0 ? "left" : "right",
                             .robot_from_sensor = {.planar = {0.0, 0.0, side}, .z = 0.5},
                             .model = model});
  }
  return robot;
}

World room_with_tags() {
  World world = room_with_path();
  for (int i = 0; i < 5; ++i) {
    world.tags.push_back({"tag_" + std::to_string(i), upright({1.0 + i, 4.9, -kPi / 2}, 1.2), 0});
  }
  return world;
}

TEST(Recorder, RoundsOfAReaderComeInTurnAndChangeNothingElse) {
  const RecorderOptions eight_seconds{.longest = 8.0};
  const Drive with = recorded(room_with_tags(), robot_with_antennas(), {}, 1, eight_seconds);
  const Drive without = recorded(room_with_path(), small_robot(), {}, 1, eight_seconds);
  SensorLog others;
  std::size_t rounds = 0, reads = 0;
  for (const Measurement& m : with.log) {
    const auto* round = std::get_if<RfidDetections>(&m);
    if (round == nullptr) {
      others.push_back(m);
      continue;
    }
    EXPECT_EQ(round->antenna, static_cast<int>(rounds % 2));
    EXPECT_EQ(round->robot_from_antenna.z, 0.5);
    EXPECT_NEAR(round->time, 0.25 * static_cast<double>(rounds), 1e-9);
    ++rounds;
    reads += round->reads.size();
  }
  EXPECT_EQ(rounds, 32u) << "each antenna twice a second";
  EXPECT_GT(reads, 20u);
  ASSERT_EQ(others.size(), without.log.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    ASSERT_EQ(others[i].index(), without.log[i].index());
    ASSERT_EQ(time_of(others[i]), time_of(without.log[i]));
    if (const auto* scan = std::get_if<LaserScan>(&others[i])) {
      ASSERT_EQ(scan->ranges, std::get<LaserScan>(without.log[i]).ranges);
    } else {
      ASSERT_EQ(std::get<Odometry>(others[i]).odometry_from_robot,
                std::get<Odometry>(without.log[i]).odometry_from_robot);
    }
  }
}

TEST(Recorder, TheTruthOfReadsIsThatOfTheLogReadByRead) {
  const Robot robot = robot_with_antennas();
  const Drive drive = recorded(room_with_tags(), robot, {}, 4, {.longest = 8.0});
  ASSERT_EQ(drive.recording.truth.tags.size(), 5u);
  EXPECT_EQ(drive.recording.truth.tags[3].world_from_tag.position, Eigen::Vector3d(4.0, 4.9, 1.2));
  const std::vector<TruthRead> truth = true_reads(drive.recording.readings, robot, Rng(4));
  std::size_t next = 0;
  for (const Measurement& m : drive.log) {
    const auto* round = std::get_if<RfidDetections>(&m);
    if (round == nullptr) continue;
    for (const RfidRead& read : round->reads) {
      ASSERT_LT(next, truth.size());
      const TruthRead& behind = truth[next++];
      EXPECT_EQ(behind.time, round->time);
      EXPECT_EQ(behind.antenna, round->antenna);
      EXPECT_EQ("tag_" + std::to_string(behind.tag), read.tag);
    }
  }
  EXPECT_EQ(next, truth.size());
}

TEST(Recorder, TheDriverFollowsItsPathToTheEnd) {
  const Drive run = recorded(room_with_path(), small_robot(), {}, 1);
  EXPECT_TRUE(run.recording.end.is_complete);
  const Pose2 end = run.recording.truth.states.back().world_from_robot;
  EXPECT_LT((end.position() - Eigen::Vector2d(6.5, 4.0)).norm(), 0.25);
  for (const StampedStates& states : run.recording.truth.states) {
    EXPECT_GT(states.world_from_robot.y, 0.8);  // never far off its straight legs
    EXPECT_LT(states.world_from_robot.x, 6.8);
  }
}

TEST(Recorder, EveryScanHasOdometryOfItsStampBeforeIt) {
  const Drive run = recorded(room_with_path(), small_robot(), {}, 1);
  ASSERT_EQ(run.log.size(), 2 * run.recording.truth.beams.size());
  for (std::size_t i = 0; i + 1 < run.log.size(); i += 2) {
    ASSERT_TRUE(std::holds_alternative<Odometry>(run.log[i]));
    ASSERT_TRUE(std::holds_alternative<LaserScan>(run.log[i + 1]));
    ASSERT_EQ(time_of(run.log[i]), time_of(run.log[i + 1]));
  }
}

TEST(Recorder, ScansComeAtTheLasersRate) {
  const Drive run = recorded(room_with_path(), small_robot(), {}, 1);
  const std::vector<IdealScan> scans = all_of<IdealScan>(run.recording);
  for (std::size_t i = 1; i < scans.size(); ++i) {
    EXPECT_NEAR(scans[i].time - scans[i - 1].time, 0.2, 1e-9);
  }
}

TEST(Recorder, TheTruthIsWhatABeamReadsWithoutNoise) {
  Robot robot = small_robot();
  LaserNoise& noise = laser_of(robot).noise;
  noise = {.sigma_near = 0.0,
           .sigma_far = 0.0,
           .step = 0.0,
           .dark_range = 0.0,
           .miss_probability = 0.0,
           .short_probability = 0.0,
           .random_probability = 0.0,
           .mixed_pixels = MixedPixels::off};
  const Drive run = recorded(room_with_path(), robot, {.walkers = 2}, 1);
  std::size_t scan = 0;
  for (const Measurement& m : run.log) {
    const auto* reading = std::get_if<LaserScan>(&m);
    if (reading == nullptr) continue;
    const BeamTruthOfScan& truth = run.recording.truth.beams[scan++];
    for (std::size_t k = 0; k < reading->ranges.size(); ++k) {
      const double expected = std::min<double>(truth.beams[k].range, reading->max_range);
      ASSERT_NEAR(reading->ranges[k], expected, 1e-6);
    }
  }
}

TEST(Recorder, BeamsOnPeopleAreLabelledAsSuch) {
  const Drive run = recorded(room_with_path(), small_robot(), {.walkers = 2, .standing = 1}, 1);
  const Truth& truth = run.recording.truth;
  std::size_t on_walkers = 0;
  std::size_t on_standing = 0;
  for (const BeamTruthOfScan& scan : truth.beams) {
    for (const BeamTruth& beam : scan.beams) {
      if (beam.entity < 0) continue;
      const TruthEntity& entity = truth.entities[static_cast<std::size_t>(beam.entity)];
      if (entity.kind != EntityKind::person) {
        EXPECT_EQ(beam.motion, Motion::still);
        continue;
      }
      EXPECT_LE(beam.part, 1);  // a leg: the laser is below the trunk
      if (entity.name == "person 3") ++on_standing;
      if (entity.name != "person 3" && beam.motion == Motion::moving) ++on_walkers;
    }
  }
  EXPECT_GT(on_walkers, 10u);
  EXPECT_GT(on_standing, 10u);
}

TEST(Recorder, TheSameSeedGivesTheSameLogAndTruth) {
  const CrowdOptions people{.walkers = 2, .standing = 1};
  const Drive a = recorded(room_with_path(), small_robot(), people, 5);
  const Drive b = recorded(room_with_path(), small_robot(), people, 5);
  const auto poses = [](const Drive& drive) {
    std::vector<Pose3> all;
    for (const StampedStates& states : drive.recording.truth.states) {
      for (const MovingPose& p : states.moving) all.push_back(p.world_from_part);
    }
    return all;
  };
  EXPECT_FALSE(poses(a).empty());
  EXPECT_EQ(poses(a), poses(b));
  ASSERT_EQ(a.log.size(), b.log.size());
  for (std::size_t i = 1; i < a.log.size(); i += 2) {
    ASSERT_EQ(std::get<LaserScan>(a.log[i]).ranges, std::get<LaserScan>(b.log[i]).ranges);
    ASSERT_EQ(std::get<Odometry>(a.log[i - 1]).odometry_from_robot,
              std::get<Odometry>(b.log[i - 1]).odometry_from_robot);
  }
}

TEST(Recorder, ThePersonWhoStandsAsideChangesOnlyTheBeamsThatMeetHim) {
  const Drive without = recorded(room_with_path(), small_robot(), {}, 5);
  const Drive with = recorded(room_with_path(), small_robot(), {.standing = 1}, 5);
  const auto scans_without = all_of<IdealScan>(without.recording);
  const auto scans_with = all_of<IdealScan>(with.recording);
  const std::size_t scans = std::min(scans_without.size(), scans_with.size());
  std::size_t same = 0;
  for (std::size_t s = 0; s < scans; ++s) {
    if (with.recording.truth.states[s].world_from_robot !=
        without.recording.truth.states[s].world_from_robot) {
      break;  // the driver made way
    }
    ASSERT_EQ(std::get<Odometry>(without.log[2 * s]).odometry_from_robot,
              std::get<Odometry>(with.log[2 * s]).odometry_from_robot);
    const auto& a = std::get<LaserScan>(without.log[2 * s + 1]).ranges;
    const auto& b = std::get<LaserScan>(with.log[2 * s + 1]).ranges;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto ideal_a = scans_without[s].beam(k);
      const auto ideal_b = scans_with[s].beam(k);
      if (ideal_a.size() != 1 || ideal_b.size() != 1) continue;
      if (ideal_a[0].range != ideal_b[0].range) continue;
      ASSERT_EQ(a[k], b[k]);
      ++same;
    }
  }
  EXPECT_GT(same, 1000u);
}

TEST(Recorder, WhatTheDriverIsToldIsWhatTheLogSays) {
  class Listener : public Driver {
   public:
    void add(const Measurement& m) override { heard.push_back(m); }
    DriveCommand command(double time) override {
      now = time;
      return {.forward_velocity = 0.3};
    }
    bool is_done() const override { return now > 2.0; }
    SensorLog heard;
    double now = 0.0;
  };
  const World world = room_with_path();
  const Robot robot = small_robot();
  const Rng rng(3);
  Simulation simulation(world, robot, start_of(world.paths[0]), {}, rng);
  Listener listener;
  const Recording recording = record(simulation, listener, {.tells_driver = true}, rng);
  const SensorLog log = with_noise(recording.readings, robot, rng);
  ASSERT_EQ(listener.heard.size(), log.size());
  for (std::size_t i = 1; i < log.size(); i += 2) {
    EXPECT_EQ(std::get<LaserScan>(listener.heard[i]).ranges, std::get<LaserScan>(log[i]).ranges);
    EXPECT_EQ(std::get<Odometry>(listener.heard[i - 1]).odometry_from_robot,
              std::get<Odometry>(log[i - 1]).odometry_from_robot);
  }
}

TEST(Simulation, ARobotThatStartsInAnObstacleIsRefused) {
  EXPECT_INPUT_ERROR(
      Simulation(room_with_path(), small_robot(), {4.0, 2.9, 0.0}, {}, Rng(1)),
      "robot 'small' starts inside an obstacle: 'column' of world 'small room' stands at "
      "(4.00 m, 2.90 m); start it elsewhere");
}

TEST(Simulation, EveryBeamOfATurningRobotHasItsOwnPose) {
  Robot robot = small_robot();
  robot.drive.kind = DriveKind::synchro;
  robot.drive.turn_acceleration = 100.0;
  laser_of(robot).mirror_rate = 20.0;  // a slow one: half a turn takes 25 ms
  const World world = small_room(8.0, 8.0);
  Simulation simulation(world, robot, {4.0, 4.0, 0.0}, {}, Rng(1));
  for (int i = 0; i < 100; ++i) simulation.step({.turn_velocity = 1.0});
  const double start = simulation.now().time - 0.05;
  const Simulation::Sweep sweep = simulation.sweep(0, start, 0);
  // The axis of beam k leaves at its own heading: from the middle of the room, ranges tell it.
  for (std::size_t k = 0; k < 60; ++k) {
    const Pose2 pose = simulation.at(start + laser_of(robot).beam_delay(static_cast<int>(k))).robot;
    const double heading =
        pose.theta + laser_of(robot).first_bearing + radians(3.0 * static_cast<double>(k));
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    const double to_x = c > 0 ? (8.0 - pose.x) / c : -pose.x / c;
    const double to_y = s > 0 ? (8.0 - pose.y) / s : -pose.y / s;
    EXPECT_NEAR(sweep.truth.beams[k].range, std::min(to_x, to_y), 2e-3);
  }
}

}  // namespace
}  // namespace mapbed
