#include "algorithms/input/scan_order.h"

#include <algorithm>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "algorithms/testing/remark_texts.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

SensorLog drive(double scan_period, const TestLaser& laser = {}) {
  return drive_through(furnished_room(), {{-3, 0}, {3, 0}, {3, 2}, {-2, 2}, {-2, -2}, {2, -2.5}},
                       {.laser = laser, .scan_period = scan_period}, Rng(3))
      .measurements;
}

std::vector<std::size_t> scans_in(const SensorLog& log) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (std::holds_alternative<LaserScan>(log[i])) numbers.push_back(i);
  }
  return numbers;
}

// Of the scan with this number and the next one.
void swap_stamps(SensorLog& log, std::size_t scan) {
  const std::vector<std::size_t> numbers = scans_in(log);
  auto& a = std::get<LaserScan>(log[numbers[scan]]);
  auto& b = std::get<LaserScan>(log[numbers[scan + 1]]);
  std::swap(a, b);
  std::swap(a.time, b.time);
}

// Of the first one of each pair.
std::vector<std::size_t> found_in(const SensorLog& log) {
  const std::vector<std::size_t> numbers = scans_in(log);
  std::vector<std::size_t> found;
  for (const SwappedScans& pair : swapped_scans(log)) {
    const auto at = std::find(numbers.begin(), numbers.end(), pair.first) - numbers.begin();
    EXPECT_EQ(pair.second, numbers[static_cast<std::size_t>(at) + 1]);
    found.push_back(static_cast<std::size_t>(at));
  }
  return found;
}

// 10 cm or 9 degrees from scan to scan, or 50 cm or 46 degrees.
TEST(ScanOrder, ScansWithEachOthersStampsAreFoundWhileTheRobotMoves) {
  for (const double period : {0.2, 1.0}) {
    for (const TestLaser& laser :
         {TestLaser{}, TestLaser{361, -kPi / 2, radians(0.5), 30.0, {0.1, 0.0, 0.2}},
          TestLaser{271, radians(135), radians(-1), 8.0, {}}}) {
      SensorLog log = drive(period, laser);
      const std::size_t last = scans_in(log).size() - 1;
      const std::vector<std::size_t> swapped{last / 5, last / 2, last - 6};
      for (const std::size_t scan : swapped) swap_stamps(log, scan);
      EXPECT_EQ(found_in(log), swapped) << period;
    }
  }
}

TEST(ScanOrder, IsMendedAndToldWithItsTime) {
  const SensorLog right = drive(0.2);
  SensorLog log = right;
  swap_stamps(log, 40);
  const std::vector<SwappedScans> swapped = swapped_scans(log);
  EXPECT_THAT(texts_of(remarks_on(swapped, time_of(log.front()))),
              ElementsAre(HasSubstr("each other's stamps from 8.0 s to 8.2 s after the start")));
  const SensorLog mended = in_order(log, swapped);
  for (const std::size_t i : scans_in(log)) {
    EXPECT_EQ(std::get<LaserScan>(mended[i]).ranges, std::get<LaserScan>(right[i]).ranges) << i;
    EXPECT_EQ(time_of(mended[i]), time_of(right[i]));
  }
}

TEST(ScanOrder, IsNotDoubtedWhereStampsAreRight) {
  for (const double period : {0.2, 1.0, 3.0}) EXPECT_THAT(found_in(drive(period)), IsEmpty());
}

// Nobody could tell.
TEST(ScanOrder, IsNotDoubtedWhereTheRobotStandsOrOdometryIsMissing) {
  SensorLog standing;
  Rng rng(1);
  for (int i = 0; i < 60; ++i) {
    standing.emplace_back(Odometry{.time = 0.2 * i});
    standing.emplace_back(
        with_range_noise(scan_of(furnished_room(), {1, 1, 0}, {}, 0.2 * i), 0.02, rng));
  }
  EXPECT_THAT(swapped_scans(standing), IsEmpty());
  std::erase_if(standing, [](const Measurement& m) { return std::holds_alternative<Odometry>(m); });
  EXPECT_THAT(swapped_scans(standing), IsEmpty());
  EXPECT_THAT(swapped_scans({}), IsEmpty());
}

// Odometry that stands still and catches up is wrong from scan to scan, in any order.
TEST(ScanOrder, IsNotTakenForOdometryThatIsWrong) {
  const SensorLog right = drive(0.2);
  for (const int stalled : {1, 2, 4}) {
    for (int from = 20; from < 130; from += 11) {
      SensorLog log = right;
      const Odometry* held = nullptr;
      int reading = 0;
      for (Measurement& m : log) {
        auto* odometry = std::get_if<Odometry>(&m);
        if (odometry == nullptr) continue;
        if (reading > from && reading <= from + stalled) {
          odometry->odometry_from_robot = held->odometry_from_robot;
        } else {
          held = odometry;
        }
        ++reading;
      }
      EXPECT_THAT(swapped_scans(log), IsEmpty()) << from;
    }
  }
}

}  // namespace
}  // namespace mapbed
