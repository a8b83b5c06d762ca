// Where a scan says nothing, both neighbours on the path decide.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/refinement/trajectory_refinement.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

class RefinementBetweenNeighbours : public ::testing::Test {
 protected:
  // Three steps of 1 m straight on; the one after is drawn 0.3 m to the left.
  RefinedPath refined_once() const {
    const Pose2 ahead{1.0, 0.0, 0.0};
    return refined({{{0.0, 0.0, 0.0}, {}, &blind_},
                    {{1.0, 0.1, 0.0}, ahead, &blind_},
                    {{2.0, 0.3, 0.0}, ahead, &blind_}},
                   {}, {.rounds = 1});
  }
  ScanForWeighting blind_;
};

TEST_F(RefinementBetweenNeighbours, APoseLiesBetweenWhatThoseBeforeAndAfterSay) {
  const RefinedPath path = refined_once();
  // Both say it with the same sigma: (1, 0) from before, (1, 0.3) from after.
  EXPECT_NEAR(path.poses[1].x, 1.0, 0.03);
  EXPECT_NEAR(path.poses[1].y, 0.15, 0.01);
}

TEST_F(RefinementBetweenNeighbours, TheFirstPoseHoldsThePath) {
  EXPECT_THAT(refined_once().poses[0], IsNear(Pose2{}, Tolerance{1e-12, 1e-12}));
}

TEST_F(RefinementBetweenNeighbours, TheLastPoseFollowsTheOneBefore) {
  const RefinedPath path = refined_once();
  const Pose2 expected = path.poses[1] * Pose2{1.0, 0.0, 0.0};
  EXPECT_THAT(path.poses[2], IsNear(expected, Tolerance{1e-6, 1e-6}));
}

TEST(MatchedBeside, AScanWithoutHitsStaysWhereItWasCarried) {
  const PosePrior prior{.mean = {1.0, 2.0, 0.5}, .information = Eigen::Matrix3d::Identity()};
  EXPECT_THAT(matched_beside({}, prior, SurfaceMap(0.1), {}),
              IsNear(prior.mean, Tolerance{1e-9, 1e-9}));
}

TEST(MatchedBeside, AScanIsMovedToWhereItFits) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const Pose2 truth{0.3, -0.4, 0.2};
  const ScanForWeighting scan = scan_for_weighting(scan_of(room, truth), {}, {}, 0.1);
  SurfaceMap map(0.1);
  map.add(scan.surface, truth);
  const PosePrior prior{.mean = truth * Pose2{0.04, -0.03, 0.02},
                        .information = Eigen::Vector3d(100.0, 100.0, 400.0).asDiagonal()};
  EXPECT_THAT(matched_beside(scan.hits, prior, map, {}), IsNear(truth, Tolerance{0.01, 0.005}));
}

}  // namespace
}  // namespace mapbed
