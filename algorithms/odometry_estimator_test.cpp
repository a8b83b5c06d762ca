#include "algorithms/odometry_estimator.h"

#include <gmock/gmock.h>

#include "algorithms/testing/remark_texts.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Tolerance kRounding{1e-12, 1e-12};

Odometry reading(double time, const Pose2& pose) {
  return {.time = time, .odometry_from_robot = pose};
}
LaserScan scan(double time) {
  LaserScan result;
  result.time = time;
  return result;
}

TEST(OdometryEstimator, StartsTheMapAtTheFirstScan) {
  OdometryEstimator estimator;
  estimator.add(reading(0.0, {5, 5, kPi / 2}));
  estimator.add(scan(0.0));
  estimator.add(reading(1.0, {5, 7, kPi / 2}));
  estimator.add(scan(1.0));
  const Estimate estimate = estimator.estimate();
  ASSERT_EQ(estimate.trajectory.size(), 2U);
  EXPECT_THAT(estimate.trajectory[0].pose, IsNear(Pose2{}, kRounding));
  EXPECT_THAT(estimate.trajectory[1].pose, IsNear(Pose2{2, 0, 0}, kRounding));
  EXPECT_THAT(estimator.pose(), IsNear(Pose2{2, 0, 0}, kRounding));
  EXPECT_EQ(estimate.untrusted_scans, 0);
  EXPECT_THAT(texts_of(estimate.remarks), IsEmpty());
}

TEST(OdometryEstimator, InterpolatesBetweenTwoReadings) {
  OdometryEstimator estimator;
  estimator.add(reading(0.0, {}));
  estimator.add(scan(0.0));
  estimator.add(scan(0.25));
  estimator.add(reading(1.0, {4, 0, 0}));
  EXPECT_THAT(estimator.estimate().trajectory[1].pose, IsNear(Pose2{1, 0, 0}, kRounding));
}

TEST(OdometryEstimator, StandsWhereThereIsNoReadingAndSaysSo) {
  OdometryEstimator estimator({.longest_gap = 1.0});
  estimator.add(reading(0.0, {}));
  estimator.add(scan(0.0));
  estimator.add(reading(1.0, {1, 0, 0}));
  estimator.add(scan(5.0));
  estimator.add(scan(6.0));
  const Estimate estimate = estimator.estimate();
  EXPECT_THAT(estimate.trajectory[2].pose, IsNear(Pose2{1, 0, 0}, kRounding));
  EXPECT_EQ(estimate.untrusted_scans, 2);
  EXPECT_THAT(texts_of(estimate.remarks),
              ElementsAre("no odometry beside 2 scans from 5.000 s to 6.000 s"));
}

TEST(OdometryEstimator, TrustsNothingWithoutOdometry) {
  OdometryEstimator estimator;
  EXPECT_THAT(estimator.estimate().trajectory, IsEmpty());
  estimator.add(scan(0.0));
  estimator.add(scan(1.0));
  const Estimate estimate = estimator.estimate();
  EXPECT_EQ(estimate.untrusted_scans, 2);
  EXPECT_THAT(texts_of(estimate.remarks), ElementsAre(HasSubstr("no odometry at all")));
  EXPECT_EQ(estimator.pose(), Pose2{});
}

}  // namespace
}  // namespace mapbed
