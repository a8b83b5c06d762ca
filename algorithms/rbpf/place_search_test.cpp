#include "algorithms/rbpf/place_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/testing/furnished_room.h"
#include "core/testing/is_near.h"

namespace mapbed {
namespace {

constexpr double kResolution = 0.1;  // [m]
const TestLaser kLaser{.beams = 361, .first_bearing = -kPi, .max_range = 15.0};
const Pose2 kTruth{-2.0, -1.0, 0.3};
const Tolerance kWithinACell{0.05, radians(0.5)};

ScanForWeighting seen_from(const Pose2& pose) {
  return scan_for_weighting(scan_of(furnished_room(), pose, kLaser),
                            {.min_spacing = 0.1, .max_points = 90}, {}, kResolution);
}

// Odometry that missed a turn, as the particle's map and the robot's scan know better.
class LikelierPlace : public ::testing::Test {
 protected:
  LikelierPlace() : map_(kResolution) {
    const Pose2 before = kTruth * Pose2{-0.5, 0.0, 0.0};
    map_.add(seen_from(before).surface, before);
  }
  std::optional<Pose2> found(const Pose2& missed, double heading_sigma) const {
    const Pose2 guess = kTruth * missed;
    return likelier_place(guess, seen_from(kTruth), map_,
                          independent_prior(guess, 0.1, 0.1, heading_sigma), likelihood_, 0.4);
  }

  SurfaceMap map_;
  SurfaceLikelihood likelihood_;
};

TEST_F(LikelierPlace, IsFoundWhereGaussNewtonFromTheGuessDoesNotArrive) {
  const Pose2 missed{0.0, 0.0, radians(12.0)};
  const Pose2 guess = kTruth * missed;
  ASSERT_GT(distance(likelihood_
                             .local_posterior(guess, seen_from(kTruth), map_,
                                              independent_prior(guess, 0.1, 0.1, 0.15))
                             .mode *
                         Pose2{5.0, 0.0, 0.0},
                     kTruth * Pose2{5.0, 0.0, 0.0}),
            0.3);
  const auto place = found(missed, 0.15);
  ASSERT_TRUE(place);
  EXPECT_THAT(*place, IsNear(kTruth, kWithinACell));
}

TEST_F(LikelierPlace, IsNotLookedForWhereTheGuessExplainsTheScan) {
  EXPECT_FALSE(found({0.02, 0.0, radians(0.3)}, 0.15));
}

TEST_F(LikelierPlace, LiesWithinWhatThePriorAllows) {
  EXPECT_FALSE(found({0.0, 0.0, radians(12.0)}, radians(1.0)));
}

TEST_F(LikelierPlace, IsNoneWithoutAHit) {
  EXPECT_FALSE(likelier_place(kTruth, {}, map_, independent_prior(kTruth, 0.1, 0.1, 0.15),
                              likelihood_, 0.4));
}

}  // namespace
}  // namespace mapbed
