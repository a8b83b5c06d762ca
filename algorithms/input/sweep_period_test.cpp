#include "algorithms/input/sweep_period.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "algorithms/testing/remark_texts.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Turner {
  int beams = 120;              // a full circle
  double period = 0.0;          // [s] from beam to beam
  double interval = 0.2;        // [s] from scan to scan
  double odometry_sigma = 0.0;  // [rad] of each reading
};

// Stands for a second, turns for a second at 1.5 rad/s, and so on.
SensorLog log_of(const Turner& turner) {
  const TestRoom room = furnished_room();
  const TestLaser laser{.beams = turner.beams,
                        .first_bearing = -kPi,
                        .bearing_step = 2.0 * kPi / turner.beams,
                        .max_range = 20.0};
  const auto pose = [](double time) {
    const double seconds =
        std::floor(time / 2.0) + std::clamp(std::fmod(time, 2.0) - 1.0, 0.0, 1.0);
    return Pose2{0.5, 0.2, normalized_angle(1.5 * seconds)};
  };
  Rng rng(1);
  SensorLog log;
  for (int i = 0; i < 60; ++i) {
    const double time = turner.interval * i;
    Odometry odometry{.time = time, .odometry_from_robot = pose(time)};
    odometry.odometry_from_robot.theta += rng.normal(0.0, turner.odometry_sigma);
    LaserScan scan = scan_of(room, pose(time), laser, time);
    for (int beam = 0; beam < turner.beams && turner.period != 0.0; ++beam) {
      const int place = turner.period > 0.0 ? beam : turner.beams - 1 - beam;
      const Pose2 here = pose(time + place * std::abs(turner.period));
      const double direction = here.theta + scan.bearing(static_cast<std::size_t>(beam));
      scan.ranges[static_cast<std::size_t>(beam)] =
          room.distance_to_wall(here.position(), direction);
    }
    log.push_back(odometry);
    log.push_back(with_range_noise(std::move(scan), 0.01, rng));
  }
  return log;
}

TEST(SweepPeriod, IsFoundWhereTheMirrorTurnsAllTheTime) {
  for (const double interval : {0.1, 0.18, 0.25}) {
    for (const double sign : {1.0, -1.0}) {
      const double period = sign * interval / 120.0;
      const auto found = found_periods(log_of({.period = period, .interval = interval}));
      ASSERT_EQ(found.size(), 1U) << interval << " " << sign;
      EXPECT_NEAR(found.at(0).beam_period, period, 1e-9);
      EXPECT_THAT(texts_of(remarks_on(found)), ElementsAre(HasSubstr("input.sweep.beam_period")));
    }
  }
}

TEST(SweepPeriod, IsNotFoundWhereAllBeamsAreTakenAtOnce) {
  for (const double interval : {0.1, 0.18, 0.25}) {
    EXPECT_TRUE(found_periods(log_of({.interval = interval})).empty()) << interval;
  }
}

// Odometry that errs by 1 degree is no reason either.
TEST(SweepPeriod, IsNotFoundByErrorsOfOdometry) {
  EXPECT_TRUE(found_periods(log_of({.odometry_sigma = radians(1.0)})).empty());
}

TEST(SweepPeriod, IsNotAskedForWhereTheLogStatesIt) {
  SensorLog log = log_of({.period = 0.2 / 120.0});
  for (Measurement& measurement : log) {
    if (auto* scan = std::get_if<LaserScan>(&measurement)) scan->beam_period = 0.2 / 120.0;
  }
  EXPECT_TRUE(found_periods(log).empty());
}

}  // namespace
}  // namespace mapbed
