#include "algorithms/input/blocked_beams.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "algorithms/testing/remark_texts.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SensorLog drive_in(const TestRoom& room, const std::vector<Eigen::Vector2d>& way) {
  return drive_through(room, way, {.scan_period = 0.5}, Rng(3)).measurements;
}

// Looks into all directions.
SensorLog drive() {
  return drive_in(
      furnished_room(),
      {{-3, 0}, {3, 0}, {3, 2}, {-2, 2}, {-2, -2}, {2, -2.5}, {2, 1}, {-2, -1}, {0, 2}});
}

SensorLog with_readings(SensorLog log, std::size_t from, std::size_t to,
                        const std::function<double()>& range) {
  for (Measurement& m : log) {
    auto* scan = std::get_if<LaserScan>(&m);
    if (scan == nullptr) continue;
    for (std::size_t beam = from; beam < to; ++beam) scan->ranges[beam] = range();
  }
  return log;
}

std::size_t blocked_in(const SensorLog& log) {
  const auto all = blocked_beams(log);
  return all.empty() ? 0 : all.at(0).count();
}

TEST(BlockedBeams, AreThoseThatReadTheSameWhateverWayTheRobotLooks) {
  Rng rng(2);
  const auto dirt = [&] { return 0.08 + 0.02 * rng.uniform(); };
  EXPECT_EQ(blocked_in(with_readings(drive(), 20, 60, dirt)), 40u);
  EXPECT_EQ(blocked_in(with_readings(drive(), 0, 90, dirt)), 90u);
  const auto stuck = [] { return 3.17; };
  EXPECT_EQ(blocked_in(with_readings(drive(), 100, 101, stuck)), 1u);
}

TEST(BlockedBeams, AreLeftOutAndTold) {
  const SensorLog log = with_readings(drive(), 20, 60, [] { return 0.25; });
  const auto blocked = blocked_beams(log);
  EXPECT_THAT(texts_of(remarks_on(blocked)), ElementsAre(HasSubstr("40 of the 181 beams")));
  const LaserScan before = std::get<LaserScan>(log.back());
  const LaserScan after = without_blocked(before, blocked);
  for (std::size_t beam = 0; beam < 181; ++beam) {
    const bool is_blocked = beam >= 20 && beam < 60;
    EXPECT_EQ(after.ranges[beam], is_blocked ? 0.0 : before.ranges[beam]) << beam;
  }
  LaserScan rear = before;
  rear.laser = 1;
  EXPECT_EQ(without_blocked(rear, blocked).ranges, before.ranges);
}

TEST(BlockedBeams, AreNoneOfAClearLaser) {
  EXPECT_EQ(blocked_in(drive()), 0u);
  EXPECT_EQ(blocked_in({}), 0u);
  const auto all_free = [] { return 8.0; };
  EXPECT_EQ(blocked_in(with_readings(drive(), 20, 60, all_free)), 0u);
  const auto nothing = [] { return 0.0; };
  EXPECT_EQ(blocked_in(with_readings(drive(), 20, 60, nothing)), 0u);
}

// All along, forth and back, a wall is 1 m to the left and one 1 m to the right.
TEST(BlockedBeams, AreNotWallsThatTheRobotFollows) {
  EXPECT_EQ(blocked_in(drive_in(corridor(60.0), {{-25, 0}, {25, 0}, {-25, 0}, {25, 0}})), 0u);
  EXPECT_EQ(blocked_in(drive_in(rectangular_room(3.0, 3.0), {{0, 0}, {0.3, 0}, {0, 0}, {0, 0.3}})),
            0u);
}

// Odometry that turns while the robot is held sees the same in all directions.
TEST(BlockedBeams, AreNotAllThereAre) {
  SensorLog log;
  for (int i = 0; i < 200; ++i) {
    log.emplace_back(Odometry{.time = 0.2 * i, .odometry_from_robot = {0, 0, 0.2 * i}});
    log.emplace_back(scan_of(furnished_room(), {}, {}, 0.2 * i));
  }
  EXPECT_EQ(blocked_in(log), 0u);
}

}  // namespace
}  // namespace mapbed
