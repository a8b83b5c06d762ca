#include "algorithms/rfid/rfid_weights.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/input_error.h"

namespace mapbed {
namespace {

const PiecewiseAntenna kArc{.opening = radians(91.0),
                            .range = 4.0,
                            .disc_radius = 0.5,
                            .arc_rate = 0.8,
                            .disc_rate = 0.8,
                            .elsewhere_rate = 0.02};

RfidDetections round_of(std::vector<std::string> tags, const Pose2& mount = {}) {
  RfidDetections round;
  round.robot_from_antenna.planar = mount;
  for (std::string& tag : tags) round.reads.push_back({std::move(tag)});
  return round;
}

// Free ground for 60 m about the origin.
OccupancyMap open_ground() {
  OccupancyMap map(GridFrame{.resolution = 0.5});
  for (int y = -120; y < 120; ++y) {
    for (int x = -120; x < 120; ++x) map.at({x, y}) = known(0.1);
  }
  return map;
}
const OccupancyMap kOpen = open_ground();

double weight_at(const RfidWeights& weights, const Pose2& pose) {
  double weight = 0.0;
  weights.add_log_weights({&pose, 1}, {&weight, 1});
  return weight;
}

// (7.2) by hand: half of what is believed lies in the arc, the other half where nothing is heard.
TEST(RfidWeights, SumOverWhereTheTagMayBe) {
  const std::vector<TagBelief> tags{{"a", {{2.0, 0.0}, {-2.0, 0.0}}, {0.5, 0.5}}};
  RfidWeights weights(0, kArc, tags, kOpen, {.non_detections = false});
  ASSERT_TRUE(weights.take(round_of({"a"}), {}));
  const double mean = 0.5 * (0.8 + 0.02);
  EXPECT_NEAR(weight_at(weights, {}), std::log(mean / 0.02), 1e-4);
  EXPECT_NEAR(weight_at(weights, {50.0, 0.0, 0.0}), 0.0, 1e-4);
}

TEST(RfidWeights, SilenceCountsWhereItIsAskedFor) {
  const std::vector<TagBelief> tags{{"a", {{2.0, 0.0}}, {1.0}}, {"b", {{3.0, 0.5}}, {1.0}}};
  RfidWeights both(0, kArc, tags, kOpen, {.non_detections = true});
  RfidWeights heard(0, kArc, tags, kOpen, {.non_detections = false});
  ASSERT_TRUE(both.take(round_of({"a"}), {}));
  ASSERT_TRUE(heard.take(round_of({"a"}), {}));
  EXPECT_NEAR(weight_at(heard, {}), std::log(0.8 / 0.02), 1e-4);
  EXPECT_NEAR(weight_at(both, {}), std::log(0.8 / 0.02) + std::log(0.2 / 0.98), 1e-4);
  EXPECT_TRUE(both.take(round_of({}), {}));
  EXPECT_FALSE(heard.take(round_of({}), {}));
}

TEST(RfidWeights, SilenceOfATagBehindAWallSaysNothing) {
  OccupancyMap walled = kOpen;
  for (int y = -20; y < 20; ++y) walled.at({2, y}) = known(0.9);  // from x = 1 m to 1.5 m
  const std::vector<TagBelief> tags{{"b", {{3.0, 0.5}}, {1.0}}};
  RfidWeights open(0, kArc, tags, kOpen, {.non_detections = true});
  RfidWeights behind(0, kArc, tags, walled, {.non_detections = true});
  ASSERT_TRUE(open.take(round_of({}), {}));
  ASSERT_TRUE(behind.take(round_of({}), {}));
  EXPECT_NEAR(weight_at(open, {}), std::log(0.2 / 0.98), 1e-4);
  EXPECT_EQ(weight_at(behind, {}), 0.0);
}

TEST(RfidWeights, TagsThatNobodyMappedAndOtherAntennasSayNothing) {
  const std::vector<TagBelief> tags{{"a", {{2.0, 0.0}}, {1.0}}};
  RfidWeights weights(0, kArc, tags, kOpen, {.non_detections = false});
  EXPECT_FALSE(weights.take(round_of({"stranger"}), {}));
  RfidDetections other = round_of({"a"});
  other.antenna = 1;
  EXPECT_FALSE(weights.take(other, {}));
  EXPECT_FALSE(weights.take(Odometry{}, {}));
}

TEST(RfidWeights, TheAntennasMountCounts) {
  const std::vector<TagBelief> tags{{"a", {{0.0, 2.0}}, {1.0}}};
  RfidWeights weights(0, kArc, tags, kOpen, {.non_detections = false});
  ASSERT_TRUE(weights.take(round_of({"a"}, {0.1, 0.0, radians(90.0)}), {}));
  EXPECT_NEAR(weight_at(weights, {}), std::log(0.8 / 0.02), 1e-4);
  EXPECT_NEAR(weight_at(weights, {0.0, 0.0, kPi}), 0.0, 1e-4);
}

// "We simply place samples only in the potential detection range", section 7.4.
TEST(RfidWeights, ProposesPosesFromWhichTheTagIsHeard) {
  const std::vector<TagBelief> tags{{"a", {{7.0, -3.0}}, {1.0}}};
  RfidWeights weights(0, kArc, tags, kOpen, {.non_detections = false});
  EXPECT_FALSE(weights.take(round_of({}), {}));
  Rng rng(4);
  EXPECT_FALSE(weights.propose(rng).has_value());
  ASSERT_TRUE(weights.take(round_of({"a"}, {0.1, 0.0, radians(45.0)}), {}));
  int heard = 0;
  for (int i = 0; i < 500; ++i) {
    const auto pose = weights.propose(rng);
    ASSERT_TRUE(pose.has_value());
    if (weight_at(weights, *pose) > 1.0) ++heard;
  }
  // Of the square of 8 m the arc and the disc are 0.21, at 0.8; the rest is heard at 0.02.
  EXPECT_GT(heard, 425);
}

TEST(RfidWeights, RefuseStrengthsThatWereNotLearned) {
  EXPECT_THROW(RfidWeights(0, kArc, {}, kOpen, {.rssi = true}), InputError);
}

TEST(RfidWeights, AStrongAnswerComesFromNear) {
  const std::vector<TagBelief> tags{{"a", {{0.0, 0.0}}, {1.0}}};
  RfidWeights weights(0, SmoothAntenna{}, tags, kOpen, {.non_detections = false, .rssi = true});
  RfidDetections round = round_of({"a"});
  round.reads[0].rssi = SmoothAntenna{}.rssi;  // as from 1 m ahead
  ASSERT_TRUE(weights.take(round, {}));
  EXPECT_GT(weight_at(weights, {-1.0, 0.0, 0.0}), weight_at(weights, {-3.0, 0.0, 0.0}) + 3.0);
}

}  // namespace
}  // namespace mapbed
