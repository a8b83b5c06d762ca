#include "algorithms/localization/monte_carlo_localizer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "algorithms/grid/wall_map.h"
#include "algorithms/localization/beam_model_weights.h"
#include "algorithms/testing/furnished_room.h"
#include "algorithms/testing/remark_texts.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

DriveOptions drive_options(double start_time = 1000.0) {
  DriveOptions drive;
  drive.laser = {.beams = 181, .max_range = 20.0};
  drive.start_time = start_time;
  return drive;
}

std::shared_ptr<const OccupancyMap> map_by(const RecordedLog& drive) {
  return std::make_shared<OccupancyMap>(wall_map(drive.measurements, drive.true_poses));
}

// By a drive to and fro, not that on which the robot is to be found.
std::shared_ptr<const OccupancyMap> map_of(const TestRoom& room) {
  return map_by(
      drive_through(room, {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}, {-3, -1}}, drive_options(), Rng(1)));
}

RecordedLog drive_in(const TestRoom& room) {
  return drive_through(room, {{2, 1}, {-2, 1}, {-2, -1}, {2, -1}}, drive_options(), Rng(2));
}

struct Told {
  std::optional<Pose2> start = {};
  std::shared_ptr<const OccupancyMap> map = {};
};

Estimate after(const RecordedLog& log, const Told& told, const MonteCarloOptions& options = {}) {
  const FreeSpace space(told.map);
  MonteCarloLocalizer::AllWeights weights;
  weights.push_back(make_laser_weights(options.laser, space, Rng(3)));
  MonteCarloLocalizer localizer(options, space, std::move(weights), told.start, Rng(4));
  for (const Measurement& measurement : log.measurements) localizer.add(measurement);
  return localizer.estimate();
}

bool was_lost(const Estimate& estimate, double time) {
  return std::any_of(estimate.lost.begin(), estimate.lost.end(), [&](const TimeInterval& lost) {
    return time >= lost.from && time <= lost.to;
  });
}

// [m] where the robot's place counts as known.
double largest_known_error(const RecordedLog& log, const Estimate& estimate) {
  double largest = 0.0;
  for (const Stamped<Pose2>& stamped : estimate.trajectory) {
    if (was_lost(estimate, stamped.time)) continue;
    largest = std::max(largest, distance(stamped.pose, *pose_at(log.true_poses, stamped.time)));
  }
  return largest;
}

TEST(MonteCarloLocalizer, FindsTheRobotAnywhereInTheMapAndFollowsIt) {
  const RecordedLog log = drive_in(furnished_room());
  const Estimate estimate = after(log, {.map = map_of(furnished_room())});
  ASSERT_THAT(estimate.trajectory, SizeIs(log.true_poses.size()));
  ASSERT_THAT(estimate.covariances, SizeIs(log.true_poses.size()));
  const double start = log.true_poses.front().time, end = log.true_poses.back().time;
  EXPECT_FALSE(was_lost(estimate, end));
  ASSERT_THAT(estimate.lost, SizeIs(1));  // at the beginning
  EXPECT_LT(estimate.lost.front().to, start + 0.5 * (end - start));
  EXPECT_THAT(texts_of(estimate.remarks),
              Contains(HasSubstr("the place on the map is known from")));
  // Half a cell of the map, and the laser's noise, for the mean of the particles: 5 sigma.
  EXPECT_THAT(estimate.trajectory.back().pose, IsNear(log.true_poses.back().pose, {0.15, 0.05}));
  EXPECT_LT(largest_known_error(log, estimate), 0.5);
}

TEST(MonteCarloLocalizer, FollowsTheRobotFromAStartWithAHundredParticles) {
  const RecordedLog log = drive_in(furnished_room());
  const Pose2 start = log.true_poses.front().pose * Pose2{0.2, -0.1, 0.1};
  const Estimate estimate = after(log, {.start = start, .map = map_of(furnished_room())},
                                  {.particles = {.least = 100, .most = 100}});
  EXPECT_THAT(estimate.lost, IsEmpty());
  EXPECT_LT(largest_known_error(log, estimate), 0.3);
}

TEST(MonteCarloLocalizer, SaysThatItIsNotKnownInTheMapOfAnotherPlace) {
  TestRoom elsewhere = rectangular_room(9.0, 14.0);  // as wide as the right one is deep
  elsewhere.add_box({1.0, 3.0}, 2.6, 0.9, 0.4);
  elsewhere.add_box({-2.0, -4.0}, 0.9, 3.0, 0.2);
  const RecordedLog log = drive_in(furnished_room());
  for (const std::optional<Pose2>& start : {std::optional<Pose2>{}, {Pose2{0, 0, 0}}}) {
    const Estimate estimate = after(log, {.start = start, .map = map_of(elsewhere)});
    int known = 0;
    for (const Stamped<Pose2>& stamped : estimate.trajectory) {
      known += was_lost(estimate, stamped.time) ? 0 : 1;
    }
    // The other room is as wide, so that it fits for a while; a belief of 95 % is wrong in one of
    // twenty cases, and a start that is told is believed until scans contradict it.
    const double share = 0.1;
    EXPECT_LE(known, share * static_cast<double>(estimate.trajectory.size()));
    EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("is not known from")));
  }
}

TEST(MonteCarloLocalizer, IsFoundAgainWhereTheRobotWasCarried) {
  RecordedLog log = drive_in(furnished_room());
  const Pose2 odometry = std::get<Odometry>(log.measurements.end()[-2]).odometry_from_robot;
  const double carried = log.true_poses.back().time + 0.25;
  const RecordedLog there = drive_through(furnished_room(), {{-3, -2}, {3, -2}, {3, 2}, {-3, 2}},
                                          drive_options(carried), Rng(5));
  for (Measurement measurement : there.measurements) {
    if (auto* reading = std::get_if<Odometry>(&measurement)) {
      reading->odometry_from_robot = odometry * reading->odometry_from_robot;
    }
    log.measurements.push_back(measurement);
  }
  log.true_poses.insert(log.true_poses.end(), there.true_poses.begin(), there.true_poses.end());
  const Estimate estimate = after(log, {.map = map_of(furnished_room())});
  EXPECT_TRUE(was_lost(estimate, carried + 1.0));
  EXPECT_FALSE(was_lost(estimate, log.true_poses.back().time));
  EXPECT_THAT(estimate.trajectory.back().pose, IsNear(log.true_poses.back().pose, {0.15, 0.05}));
}

// In at a door, along a corridor that no map shows, and back.
TEST(MonteCarloLocalizer,
     ARobotThatLeavesTheMapIsNeverTakenForOneThatIsThereAndIsKnownWhenItIsBack) {
  TestRoom room({{{-6, -4.5}, {6, -4.5}},
                 {{6, -4.5}, {6, -1}},
                 {{6, 1}, {6, 4.5}},
                 {{6, 4.5}, {-6, 4.5}},
                 {{-6, 4.5}, {-6, -4.5}},
                 {{6, -1}, {40, -1}},
                 {{40, -1}, {40, 1}},
                 {{40, 1}, {6, 1}}});
  room.add_box({-4.0, 3.2}, 1.5, 0.8);
  room.add_box({-5.2, -2.5}, 0.7, 1.2);
  room.add_box({1.0, -4.0}, 2.2, 0.5, 0.3);
  DriveOptions drive = drive_options();
  drive.laser.max_range = 8.0;
  const auto map =
      map_by(drive_through(room, {{-3, -2}, {2, -2}, {2, 2}, {-3, 2}, {-3, -1}}, drive, Rng(1)));
  const RecordedLog log =
      drive_through(room, {{-2, 0}, {2, 0}, {30, 0}, {2, 0}, {-2, 1}}, drive, Rng(2));
  const Estimate estimate = after(log, {.start = log.true_poses.front().pose, .map = map});
  const double out = 0.5 * (log.true_poses.front().time + log.true_poses.back().time);
  EXPECT_TRUE(was_lost(estimate, out));  // 28 m from the door
  EXPECT_FALSE(was_lost(estimate, log.true_poses.back().time));
  EXPECT_LT(largest_known_error(log, estimate), 1.0);
}

TEST(MonteCarloLocalizer, AStartThatIsToldWrongIsFoundOut) {
  const RecordedLog log = drive_in(furnished_room());
  for (const Pose2& start : {Pose2{-4.0, 2.0, 1.0}, Pose2{50.0, 0.0, 0.0}}) {
    const Estimate estimate = after(log, {.start = start, .map = map_of(furnished_room())});
    EXPECT_TRUE(was_lost(estimate, log.true_poses.front().time + 1.0));
    EXPECT_FALSE(was_lost(estimate, log.true_poses.back().time));
    EXPECT_THAT(estimate.trajectory.back().pose, IsNear(log.true_poses.back().pose, {0.15, 0.05}));
  }
}

TEST(MonteCarloLocalizer, ABeamModelFindsTheRobotToo) {
  const RecordedLog log = drive_in(furnished_room());
  const Estimate estimate =
      after(log, {.map = map_of(furnished_room())},
            {.particles = {.most = 3000}, .laser = {.model = LaserModel::beam}});
  EXPECT_FALSE(was_lost(estimate, log.true_poses.back().time));
  EXPECT_THAT(estimate.trajectory.back().pose, IsNear(log.true_poses.back().pose, {0.15, 0.05}));
}

// Nobody tells how a person moves who carries a laser; he is taken to be about where he was.
TEST(MonteCarloLocalizer, FollowsWithoutOdometryByRandomSteps) {
  const RecordedLog log = drive_in(furnished_room());
  const Estimate estimate =
      after(log, {.start = log.true_poses.front().pose, .map = map_of(furnished_room())},
            {.motion = ParticleMotion::random_step, .random_step = {.position = 0.5}});
  EXPECT_FALSE(was_lost(estimate, log.true_poses.back().time));
  EXPECT_LT(largest_known_error(log, estimate), 0.5);
}

// The same after half a turn: two places, and nothing says which.
TEST(MonteCarloLocalizer, IsNotKnownInARoomThatLooksAlikeAfterHalfATurn) {
  const TestRoom room = rectangular_room(10.0, 6.0);
  const RecordedLog log = drive_through(room, {{-2, -1}, {2, -1}, {2, 1}}, drive_options(), Rng(2));
  const Estimate estimate = after(log, {.map = map_of(room)});
  EXPECT_TRUE(was_lost(estimate, log.true_poses.back().time));
  EXPECT_THAT(texts_of(estimate.remarks), Contains(HasSubstr("in several places")));
}

TEST(MonteCarloLocalizer, GivesTheSameBytesForAnyNumberOfThreads) {
  const RecordedLog log = drive_in(furnished_room());
  const Told given{.map = map_of(furnished_room())};
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return after(log, given).trajectory;
  };
  const Trajectory one = with_threads(1), two = with_threads(2), eight = with_threads(8);
  ASSERT_THAT(two, SizeIs(one.size()));
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pose, two[i].pose);
    EXPECT_EQ(one[i].pose, eight[i].pose);
  }
}

}  // namespace
}  // namespace mapbed
