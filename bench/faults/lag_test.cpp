#include "bench/faults/lag.h"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;

TEST(Lag, StampsOdometryLateAndKeepsTheOrderOfTime) {
  const BrokenLog broken = with_lag(small_log(2), {.delay = 1.0}, Rng(1));
  std::vector<std::pair<double, bool>> order;  // stamp, is a scan
  for (const Measurement& m : broken.log) order.emplace_back(time_of(m), m.index() == 1);
  using P = std::pair<double, bool>;
  EXPECT_THAT(order, ElementsAre(P{100.0, true}, P{101.0, false}, P{101.0, true}, P{102.0, false},
                                 P{102.0, true}, P{103.0, false}));
  // At 101 odometry tells where the robot was at 100.
  EXPECT_EQ(std::get<Odometry>(broken.log[1]).odometry_from_robot, Pose2{});
  EXPECT_THAT(broken.when, ElementsAre(TimeInterval{100.0, 103.0}));
}

}  // namespace
}  // namespace mapbed
