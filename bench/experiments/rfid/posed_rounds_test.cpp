#include "bench/experiments/rfid/posed_rounds.h"

#include <gtest/gtest.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

RfidDetections round_at(double time, int antenna = 0) {
  RfidDetections round;
  round.time = time;
  round.antenna = antenna;
  round.robot_from_antenna.planar = {0.0, 0.5, 0.0};
  return round;
}

const Trajectory kPath{{10.0, {0.0, 0.0, 0.0}}, {12.0, {4.0, 0.0, 0.0}}};

TEST(PosedRounds, LieBetweenThePathsPosesByTheirTime) {
  const SensorLog log{round_at(10.5), Odometry{10.6, {}}, round_at(12.0)};
  const std::vector<PosedRound> rounds = posed_rounds(log, kPath);
  ASSERT_EQ(rounds.size(), 2u);
  EXPECT_NEAR(rounds[0].map_from_robot.x, 1.0, 1e-12);
  EXPECT_NEAR(rounds[0].map_from_antenna().y, 0.5, 1e-12);
  EXPECT_NEAR(rounds[1].map_from_robot.x, 4.0, 1e-12);
}

TEST(PosedRounds, OutsideOfThePathsTimeNobodyKnowsThePose) {
  EXPECT_TRUE(posed_rounds({round_at(9.9), round_at(12.1)}, kPath).empty());
}

TEST(PosedRounds, AntennasAreCountedByTheLargestNumber) {
  EXPECT_EQ(antennas_in({round_at(1.0, 1), round_at(2.0, 0)}), 2);
  EXPECT_THROW(antennas_in({Odometry{1.0, {}}}), InputError);
}

}  // namespace
}  // namespace mapbed
