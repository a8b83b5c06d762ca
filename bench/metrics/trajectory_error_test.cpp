#include "bench/metrics/trajectory_error.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr double kRounding = 1e-12;

// `count` poses a metre and a second apart, on the x axis.
Trajectory straight(int count) {
  Trajectory path;
  for (int i = 0; i < count; ++i) path.push_back({1.0 * i, {1.0 * i, 0, 0}});
  return path;
}

Trajectory moved(const Pose2& world_from_map, Trajectory path) {
  for (Stamped<Pose2>& stamped : path) stamped.pose = world_from_map * stamped.pose;
  return path;
}

TEST(Association, TakesTheNearestStampWithinTheLimit) {
  const Trajectory truth{{0.0, {}}, {1.0, {1, 0, 0}}, {2.0, {2, 0, 0}}};
  const Trajectory estimate{{0.004, {}}, {0.98, {}}, {1.995, {}}, {2.2, {}}};
  const std::vector<PosePair> pairs = associated(truth, estimate, 0.01);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].time, 0.004);
  EXPECT_EQ(pairs[1].time, 1.995);
  EXPECT_EQ(pairs[1].truth.x, 2.0);
}

TEST(Association, IsByThePosesOfTheShorterTrajectory) {
  const Trajectory estimate{{0.0, {}}};
  const Trajectory truth{{-0.3, {}}, {0.2, {7, 0, 0}}, {0.9, {}}};
  const std::vector<PosePair> pairs = associated(truth, estimate, 0.5);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].truth.x, 7.0);
}

TEST(Association, TakesTheEarlierOneOfTwoStampsThatAreAsNear) {
  const Trajectory truth{{0.0, {3, 0, 0}}, {1.0, {4, 0, 0}}, {2.0, {}}};
  const std::vector<PosePair> pairs = associated(truth, {{0.5, {}}}, 0.6);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].truth.x, 3.0);
}

TEST(Statistics, OfFourNumbersAreThoseByHand) {
  const ErrorStatistics s = statistics_of({4.0, 1.0, 3.0, 2.0});
  EXPECT_EQ(s.count, 4);
  EXPECT_NEAR(s.mean, 2.5, kRounding);
  EXPECT_NEAR(s.median, 2.5, kRounding);
  EXPECT_NEAR(s.rmse, std::sqrt(7.5), kRounding);
  EXPECT_NEAR(s.sigma, std::sqrt(1.25), kRounding);
  EXPECT_EQ(s.min, 1.0);
  EXPECT_EQ(s.max, 4.0);
  EXPECT_TRUE(std::isnan(statistics_of({}).rmse));
}

TEST(Alignment, FindsTheMotionBetweenTwoFrames) {
  const Trajectory truth{{0, {0, 0, 0}}, {1, {3, 1, 1}}, {2, {2, 5, 2}}, {3, {-1, 2, 3}}};
  const Pose2 map_from_world{4.0, -2.0, radians(150)};
  const std::vector<PosePair> pairs = associated(truth, moved(map_from_world, truth));
  EXPECT_THAT(alignment(pairs), IsNear(inverse(map_from_world), Tolerance{1e-12, 1e-12}));
  const PoseErrors error = absolute_error(pairs, alignment(pairs));
  EXPECT_NEAR(error.translation.max, 0.0, kRounding);
  EXPECT_NEAR(error.rotation.max, 0.0, kRounding);
}

TEST(Alignment, IsTheLeastSquaresOne) {
  // The true square is 2 m wide, the estimated one 4 m: no motion can do better than to put one in
  // the middle of the other; each corner is then sqrt(2) m off.
  const Trajectory truth{{0, {1, 1, 0}}, {1, {-1, 1, 0}}, {2, {-1, -1, 0}}, {3, {1, -1, 0}}};
  const Trajectory wide{{0, {2, 2, 0}}, {1, {-2, 2, 0}}, {2, {-2, -2, 0}}, {3, {2, -2, 0}}};
  const std::vector<PosePair> pairs = associated(truth, moved({5, 6, 0.7}, wide));
  const PoseErrors error = absolute_error(pairs, alignment(pairs));
  EXPECT_NEAR(error.translation.rmse, std::sqrt(2.0), kRounding);
  EXPECT_NEAR(error.translation.sigma, 0.0, 1e-7);
}

TEST(Alignment, OfARobotThatStoodMatchesTheFirstPose) {
  const std::vector<PosePair> pairs{{0, {1, 2, 0.5}, {}}, {1, {1, 2, 0.5}, {}}};
  EXPECT_THAT(alignment(pairs), IsNear(Pose2{1, 2, 0.5}, Tolerance{1e-12, 1e-12}));
}

TEST(RelativeError, ByFramesComparesMotionsNotPlaces) {
  Trajectory estimate = moved({3, 4, 1}, straight(7));
  for (std::size_t i = 4; i < 7; ++i) {  // one wrong step of 0.3 m, all others right
    estimate[i].pose = estimate[i].pose * Pose2{0.3, 0, 0};
  }
  const std::vector<PosePair> pairs = associated(straight(7), estimate);
  const PoseErrors steps = relative_error(pairs, {});
  EXPECT_EQ(steps.translation.count, 6);
  EXPECT_NEAR(steps.translation.max, 0.3, kRounding);
  EXPECT_NEAR(steps.translation.mean, 0.05, kRounding);
  // Every second frame: 0-2, 2-4, 4-6; from every frame: 0-2 … 4-6, of which two see the step.
  EXPECT_EQ(relative_error(pairs, {.delta = 2}).translation.count, 3);
  const PoseErrors all = relative_error(pairs, {.delta = 2, .all_pairs = true});
  EXPECT_EQ(all.translation.count, 5);
  EXPECT_NEAR(all.translation.mean, 2 * 0.3 / 5, kRounding);
}

TEST(RelativeError, ByMetresIsMeasuredAlongTheEstimate) {
  const std::vector<PosePair> pairs = associated(straight(11), straight(11));
  const RelativeErrorOptions chained{.delta = 3, .unit = PathUnit::meters};
  EXPECT_EQ(relative_error(pairs, chained).translation.count, 2);  // cuts at 3, 6 and 9 m
  RelativeErrorOptions all = chained;
  all.all_pairs = true;
  EXPECT_EQ(relative_error(pairs, all).translation.count, 8);  // 0-3 … 7-10
  all.delta = 2.5;
  all.tolerance = 0.1;  // 0.25 m: neither 2 nor 3 m will do
  EXPECT_EQ(relative_error(pairs, all).translation.count, 0);
}

TEST(AbsoluteError, OfTheHeadingCountsTheSameToBothSides) {
  const std::vector<PosePair> pairs{{0, {0, 0, 0}, {0, 0, 0.2}},
                                    {1, {1, 0, 0}, {1, 0, -0.4}},
                                    {2, {2, 0, 3.1}, {2, 0, -3.1}}};  // across the wrap
  const PoseErrors errors = absolute_error(pairs, {});
  EXPECT_NEAR(errors.rotation.mean, (0.2 + 0.4 + 2 * kPi - 6.2) / 3, kRounding);
  EXPECT_NEAR(errors.rotation.min, 2 * kPi - 6.2, kRounding);
}

TEST(RelativeError, ByMetresBeginsAtEveryPoseUpToTheLastButOne) {
  const std::vector<PosePair> pairs = associated(straight(4), straight(4));
  const RelativeErrorOptions options{.delta = 1.0, .unit = PathUnit::meters, .all_pairs = true};
  EXPECT_EQ(relative_error(pairs, options).translation.count, 3);
}

// The robot turned where it stood: the motion of a metre ends where it arrived.
TEST(RelativeError, ByMetresEndsAtTheFirstPoseOfAPlace) {
  const Trajectory truth{{0, {0, 0, 0}}, {1, {0.9, 0, 0}}, {2, {0.9, 0, 0}}, {3, {2.5, 0, 0}}};
  Trajectory estimate = truth;
  estimate[2].pose.theta = 0.5;
  const RelativeErrorOptions options{
      .delta = 1.0, .unit = PathUnit::meters, .all_pairs = true, .tolerance = 0.2};
  const PoseErrors errors = relative_error(associated(truth, estimate), options);
  EXPECT_EQ(errors.rotation.count, 1);
  EXPECT_NEAR(errors.rotation.max, 0.0, kRounding);
}

TEST(ErrorOverPath, ComparesMotionsOfThatLength) {
  // Every metre the estimate turns 1 degree too far and stays on its line otherwise.
  Trajectory estimate = straight(21);
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    estimate[i].pose.theta = radians(static_cast<double>(i));
  }
  const PoseErrors error = error_over_path(straight(21), estimate, 5.0);
  EXPECT_EQ(error.rotation.count, 16);  // 0-5 … 15-20
  EXPECT_NEAR(error.rotation.median, radians(5), kRounding);
}

TEST(ErrorOverPath, LeavesOutStampsThatTheEstimateDoesNotCover) {
  Trajectory estimate = straight(11);
  estimate.erase(estimate.begin(), estimate.begin() + 3);
  EXPECT_EQ(error_over_path(straight(11), estimate, 5.0).translation.count, 3);
}

}  // namespace
}  // namespace mapbed
