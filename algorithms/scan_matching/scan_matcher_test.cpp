#include "algorithms/scan_matching/scan_matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

LikelihoodField field_of(const TestRoom& room, const Pose2& seen_from) {
  LikelihoodField field;
  const auto surface = surface_points(scan_of(room, seen_from), 30.0, 0.2, 0.05);
  field.add(transformed(surface, seen_from));
  return field;
}

FieldPoints points_of(const LaserScan& scan, const LikelihoodField& field) {
  return to_field_points(hit_points(scan, {}), field.resolution());
}

class RecoversStartError : public ::testing::TestWithParam<Pose2> {};

TEST_P(RecoversStartError, InARectangularRoom) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const Pose2 truth{0.3, -0.4, 0.2};
  const LikelihoodField field = field_of(room, {0.1, -0.3, 0.1});

  const ScanMatch match = match_scan(points_of(scan_of(room, truth), field), field,
                                     PosePrior{.mean = truth * GetParam()});

  // The map's points lie up to 5 cm apart along the walls; across them they are exact.
  EXPECT_THAT(match.map_from_robot, IsNear(truth, Tolerance{0.01, 0.004}));
  EXPECT_TRUE(match.trustworthy);
}

INSTANTIATE_TEST_SUITE_P(ScanMatcher, RecoversStartError,
                         ::testing::Values(Pose2{}, Pose2{0.1, 0, 0}, Pose2{0, -0.2, 0},
                                           Pose2{0, 0, 0.1}, Pose2{0.1, 0.1, -0.1}));

TEST(ScanMatcher, KeepsThePredictionWhenNothingWasHit) {
  const Pose2 prediction{1.0, 2.0, 0.5};
  const ScanMatch match = match_scan({}, LikelihoodField(), PosePrior{.mean = prediction});
  EXPECT_EQ(match.map_from_robot, prediction);
  EXPECT_EQ(match.points_used, 0);
  EXPECT_FALSE(match.trustworthy);
}

TEST(ScanMatcher, DoesNotTrustAMatchThatExplainsLittle) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const LikelihoodField elsewhere = field_of(l_shaped_room(), {50.0, 50.0, 0.0});
  const ScanMatch match =
      match_scan(points_of(scan_of(room, {}), elsewhere), elsewhere, PosePrior{});
  EXPECT_LT(match.inlier_ratio, 0.1);
  EXPECT_FALSE(match.trustworthy);
}

TEST(ScanMatcher, AStrongPriorHoldsAgainstAWeakScan) {
  const TestRoom room = corridor(60.0);
  const LikelihoodField field = field_of(room, {});
  const Pose2 ahead{0.5, 0.0, 0.0};  // the corridor looks the same there
  const ScanMatch match = match_scan(points_of(scan_of(room, ahead), field), field,
                                     independent_prior(ahead, 0.02, 0.02, 0.02));
  EXPECT_THAT(match.map_from_robot, IsNear(ahead, Tolerance{0.03, 0.01}));
}

// Steps of the climb are along the robot's axes, so where the wall is not, each one alone leads
// downhill.
TEST(ScanMatcher, IsNotCaughtOnTheRidgeOfACorridorThatLiesAslant) {
  const TestRoom room = corridor(60.0);
  const Pose2 truth{0.0, 0.0, 0.5};
  const LikelihoodField field = field_of(room, truth);
  const FieldPoints points = points_of(scan_of(room, truth), field);
  for (const double ahead : {-0.08, 0.0, 0.08}) {
    for (const double aside : {-0.08, 0.08}) {
      const Pose2 predicted{ahead, aside, 0.53};
      const Pose2 match =
          match_scan(points, field, independent_prior(predicted, 0.05, 0.05, 0.03)).map_from_robot;
      EXPECT_NEAR(match.x, predicted.x, 0.03);  // along it the prediction holds
      EXPECT_NEAR(match.y, truth.y, 0.01);
      EXPECT_NEAR(match.theta, truth.theta, 0.005);
    }
  }
}

// Gauss-Newton may go far astray from where the climb ended: then it has to be worth it.
TEST(ScanMatcher, PolishingImprovesTheClimbOrStaysBesideIt) {
  const TestRoom room = corridor(60.0);
  const LikelihoodField field = field_of(room, {});
  const FieldPoints points = points_of(scan_of(room, {}), field);
  for (const double ahead : {-0.2, 0.0}) {
    for (const double aside : {-0.3, -0.1, 0.1, 0.3}) {
      for (const double turn : {-0.3, -0.1, 0.1, 0.3}) {
        const PosePrior prediction = independent_prior({ahead, aside, turn}, 0.05, 0.05, 0.03);
        const ScanMatch climb = match_scan(points, field, prediction, {.polish_iterations = 0});
        const ScanMatch match = match_scan(points, field, prediction);
        const double moved = distance(match.map_from_robot, climb.map_from_robot);
        EXPECT_TRUE(match.log_posterior >= climb.log_posterior ||
                    moved <= ScanMatcherOptions{}.last_step)
            << ahead << " " << aside << " " << turn << ": moved by " << moved;
      }
    }
  }
}

}  // namespace
}  // namespace mapbed
