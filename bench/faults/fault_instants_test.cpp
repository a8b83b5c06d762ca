#include "bench/faults/fault_instants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/faults/testing/small_log.h"

namespace mapbed {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::Le;

TEST(FaultInstants, AreCountedFromTheLogsStartWhereTheyAreGiven) {
  Rng rng(1);
  EXPECT_THAT(fault_instants(small_log(), {4.0, 1.5}, 1.0, rng), ElementsAre(101.5, 104.0));
}

TEST(FaultInstants, ByChanceLieInTheMiddleOfTheLogWhileTheRobotMoves) {
  // In its last 60 s the log's robot turns, 1 rad a second, which counts for half a metre.
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng(seed);
    const std::vector<double> at = fault_instants(small_log(180), {}, 2.0, rng);
    ASSERT_EQ(at.size(), 1U);
    EXPECT_THAT(at, Each(AllOf(Ge(118.0), Le(220.0)))) << "while it drives";
  }
}

TEST(FaultInstants, OfARobotThatStandsAreAnyhow) {
  SensorLog log;
  for (int i = 0; i <= 10; ++i) log.push_back(Odometry{1.0 * i, {}});
  Rng rng(1);
  EXPECT_THAT(fault_instants(log, {}, 1.0, rng), Each(AllOf(Ge(1.0), Le(9.0))));
  EXPECT_THAT(fault_instants({}, {}, 1.0, rng), IsEmpty());
}

}  // namespace
}  // namespace mapbed
