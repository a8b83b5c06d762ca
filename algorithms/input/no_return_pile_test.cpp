#include "algorithms/input/no_return_pile.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/remark_texts.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Through a corridor whose ends are out of reach.
SensorLog corridor_drive(double max_range, double width = 2.0) {
  DriveOptions drive;
  drive.laser.max_range = max_range;
  return drive_through(corridor(60.0, width), {{0, 0}, {8, 0}}, drive, Rng(1)).measurements;
}

// Beams without return read their maximum range with the laser's noise, or `below` it.
SensorLog with_noise_on_no_return(SensorLog log, double sigma, double below = 0.0) {
  Rng rng(2);
  for (Measurement& measurement : log) {
    auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr) continue;
    for (double& range : scan->ranges) {
      if (range < scan->max_range) continue;
      range = std::min(scan->max_range, scan->max_range - below + rng.normal(0.0, sigma));
    }
  }
  return log;
}

TEST(NoReturnPile, IsFoundBelowAnyMaximumRange) {
  for (const double max_range : {4.0, 8.0, 30.0}) {
    const auto piles =
        no_return_piles(with_noise_on_no_return(corridor_drive(max_range, 0.5 * max_range), 0.01));
    ASSERT_EQ(piles.size(), 1U) << max_range;
    EXPECT_GT(piles.at(0).from, 0.98 * max_range);
    EXPECT_LT(piles.at(0).from, max_range - 0.03);  // three sigma
    EXPECT_THAT(texts_of(remarks_on(piles)), ElementsAre(HasSubstr("log.max_range=")));
  }
}

TEST(NoReturnPile, IsFoundWhereNoReadingReachesTheMaximumRange) {
  EXPECT_EQ(no_return_piles(with_noise_on_no_return(corridor_drive(6.0), 0.005, 0.03)).size(), 1U);
}

TEST(NoReturnPile, IsTakenAsNoReturn) {
  const std::map<int, NoReturnPile> piles{{0, {.from = 3.95, .max_range = 4.0, .fraction = 0.3}}};
  const LaserScan scan{.max_range = 4.0, .ranges = {1.0, 3.94, 3.97, 4.0, 0.0}};
  EXPECT_EQ(without_pile(scan, piles).ranges, (std::vector<double>{1.0, 3.94, 4.0, 4.0, 0.0}));
  LaserScan other = scan;
  other.laser = 1;
  EXPECT_EQ(without_pile(other, piles).ranges, scan.ranges);
}

TEST(NoReturnPile, IsNotMadeByWalls) {
  for (const double max_range : {2.5, 4.0, 8.0, 30.0}) {
    EXPECT_THAT(no_return_piles(corridor_drive(max_range)), IsEmpty()) << max_range;
  }
  DriveOptions drive;
  drive.laser.max_range = 4.0;
  // And by none that a robot stands before.
  SensorLog standing;
  Rng rng(3);
  for (int i = 0; i < 100; ++i) {
    standing.push_back(Odometry{.time = 0.1 * i});
    standing.push_back(with_range_noise(
        scan_of(rectangular_room(7.95, 30.0), {}, drive.laser, 0.1 * i), 0.005, rng));
  }
  EXPECT_THAT(no_return_piles(standing), IsEmpty());
  const RecordedLog room =
      drive_through(rectangular_room(6.0, 5.0), {{-2, -1}, {2, -1}, {2, 1}}, drive, Rng(3));
  EXPECT_THAT(no_return_piles(room.measurements), IsEmpty());
}

}  // namespace
}  // namespace mapbed
