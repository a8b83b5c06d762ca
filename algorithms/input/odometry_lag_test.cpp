#include "algorithms/input/odometry_lag.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// A robot that looks about in a room for 30 s, five scans and ten readings a second; its turning
// speed swings. The stamps of odometry are late by `lag`.
SensorLog looking_about(double lag, const TestRoom& room, double turn_speed = 0.8) {
  const auto heading = [&](double time) { return turn_speed * (1.0 - std::cos(time)); };
  SensorLog log;
  for (int i = 0; i < 300; ++i) {
    const double time = 0.1 * i;
    log.emplace_back(
        Odometry{.time = time + lag, .odometry_from_robot = {0.0, 0.0, heading(time)}});
    if (i % 2 == 0) log.emplace_back(scan_of(room, {0.3, 0.2, heading(time)}, {}, time));
  }
  return log;
}

TEST(OdometryLag, IsFoundWhereTheRobotTurns) {
  TestRoom furnished = rectangular_room(6.0, 5.0);
  furnished.add_box({1.5, 1.0}, 0.5, 0.5);
  for (const TestRoom& room : {furnished, l_shaped_room(), example_place()}) {
    for (const double lag : {0.1, 0.3, -0.2}) {
      const std::optional<double> found = odometry_lag(looking_about(lag, room));
      ASSERT_TRUE(found) << lag;
      EXPECT_NEAR(*found, lag, 0.03);
    }
  }
}

TEST(OdometryLag, IsNoneWhereStampsAreRight) {
  EXPECT_FALSE(odometry_lag(looking_about(0.0, rectangular_room(6.0, 5.0))));
}

TEST(OdometryLag, IsNotKnownWithoutTurnsOrOdometry) {
  EXPECT_FALSE(odometry_lag(looking_about(0.3, rectangular_room(6.0, 5.0), 0.0)));
  EXPECT_FALSE(odometry_lag({}));
}

// Each step of 0.2 s errs by itself: a reading half way between two has the mean of their errors.
TEST(OdometryLag, IsNotTakenForNoise) {
  const TestRoom room = l_shaped_room();
  Rng rng(4);
  SensorLog log;
  double heading = 0.0, told = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double time = 0.2 * i, step = 0.16 * std::sin(0.4 * time);
    heading += step;
    told += step + 0.1 * rng.normal();
    log.emplace_back(Odometry{.time = time, .odometry_from_robot = {0.0, 0.0, told}});
    log.emplace_back(scan_of(room, {0.3, 0.2, heading}, {}, time));
  }
  EXPECT_FALSE(odometry_lag(log));
}

TEST(OdometryLag, IsTakenOutOfTheStamps) {
  const SensorLog log = without_lag(looking_about(0.3, rectangular_room(6.0, 5.0)), 0.3);
  EXPECT_FALSE(odometry_lag(log));
  EXPECT_TRUE(std::is_sorted(
      log.begin(), log.end(),
      [](const Measurement& a, const Measurement& b) { return time_of(a) < time_of(b); }));
}

}  // namespace
}  // namespace mapbed
