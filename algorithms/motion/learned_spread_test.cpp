#include "algorithms/motion/learned_spread.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

constexpr MotionSpread kSpread{.position_per_meter = 0.04, .heading_per_meter = 0.07};
constexpr double kStep = 0.1;  // [m] from scan to scan

// What is learned on a way of 60 m from odometry whose forward error after 1 m has this sigma [m],
// where each match takes a share of the error that was left over out.
double learned(double sigma, double share) {
  LearnedSpread spread;
  Rng rng(3);
  double left_over = 0.0;
  for (int i = 0; i < 600; ++i) {
    left_over += rng.normal(0.0, sigma * std::sqrt(kStep));
    const double off = share * left_over;
    left_over -= off;
    spread.add({kStep, 0.0, 0.0}, 0.1, {off, 0.0, 0.0}, kSpread);
  }
  return spread.applied_to({.odometry = kSpread}).odometry.position_per_meter;
}

// Ten ways of 2 m: the ratio of variances is learned to within sqrt(2 / 10) of itself, sigma.
TEST(LearnedSpread, IsTheExpectedOneWhereOdometryIsAsGood) {
  EXPECT_LT(learned(0.04, 1.0), 0.04 * 1.4);
  EXPECT_EQ(learned(0.01, 1.0), 0.04);
}

TEST(LearnedSpread, GrowsWithTheErrorsOfOdometry) {
  EXPECT_GT(learned(0.1, 1.0), 0.06);
  EXPECT_LT(learned(0.1, 1.0), 0.12);
}

// As where a corridor tells little about the way.
TEST(LearnedSpread, IsSeenThroughMatchesThatFollowSlowly) {
  EXPECT_GT(learned(0.1, 0.1), 0.06);
}

// It counts as three sigma for the 3.5 m until the sum has forgotten it: (8 * 3.5 / 20 + 1)^0.5.
TEST(LearnedSpread, TakesASingleSlipForOne) {
  LearnedSpread spread;
  spread.add({kStep, 0.0, 0.0}, 0.1, {1.0, 0.0, 0.0}, kSpread);
  for (int i = 0; i < 100; ++i) spread.add({kStep, 0.0, 0.0}, 0.1, {}, kSpread);
  EXPECT_LT(spread.applied_to({.odometry = kSpread}).odometry.position_per_meter, 0.04 * 1.6);
}

TEST(LearnedSpread, LearnsNothingFromARobotThatStands) {
  LearnedSpread spread;
  for (int i = 0; i < 100; ++i) spread.add({}, 0.1, {0.05, 0.0, 0.0}, kSpread);
  EXPECT_EQ(spread.applied_to({.odometry = kSpread}).odometry.position_per_meter, 0.04);
}

}  // namespace
}  // namespace mapbed
