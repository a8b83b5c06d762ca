#include "algorithms/motion/track.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/is_near.h"

namespace mapbed {
namespace {

const Tolerance kExact{1e-6, 1e-6};

// Two anchors 1 m apart along the track, a scan between them and one after. The path has the second
// anchor elsewhere.
class TrackedPath : public ::testing::Test {
 protected:
  static Track track(const std::vector<Track::Break>& breaks) {
    return {.scans = {{.time = 0.0, .track_from_robot = {}, .anchors = 1, .is_anchor = true},
                      {.time = 1.0, .track_from_robot = {0.5, 0.0, 0.0}, .anchors = 1},
                      {.time = 2.0,
                       .track_from_robot = {1.0, 0.0, 0.0},
                       .anchors = 2,
                       .is_anchor = true},
                      {.time = 3.0, .track_from_robot = {1.3, 0.0, 0.0}, .anchors = 2}},
            .track_from_anchors = {{}, {1.0, 0.0, 0.0}},
            .breaks = breaks};
  }
  Trajectory all_scans(const std::vector<Track::Break>& breaks) const {
    return carried_trajectory(track(breaks), {{}, second_});
  }

  const Pose2 second_{1.0, 0.2, 0.0};
};

TEST_F(TrackedPath, TellsTheMotionsBetweenAnchors) {
  EXPECT_THAT(motion_to(track({}), 1, {{}, second_}), IsNear(Pose2{1.0, 0.0, 0.0}, kExact));
}

TEST_F(TrackedPath, AcrossABreakThePathAloneSaysHowAnchorsLie) {
  EXPECT_THAT(motion_to(track({{.time = 1.0, .anchor = 1}}), 1, {{}, second_}),
              IsNear(second_, kExact));
}

TEST_F(TrackedPath, AnchorsLieWhereThePathHasThem) {
  const Trajectory trajectory = all_scans({});
  ASSERT_EQ(trajectory.size(), 4U);
  EXPECT_EQ(trajectory[0].pose, Pose2{});
  EXPECT_EQ(trajectory[2].pose, second_);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(trajectory[i].time, static_cast<double>(i));
}

TEST_F(TrackedPath, AScanBetweenAnchorsLiesBetweenWhatBothSay) {
  // (0.5, 0) from before, (0.5, 0.2) from after, with the same sigma.
  const Pose2 between = all_scans({})[1].pose;
  EXPECT_NEAR(between.x, 0.5, 0.02);
  EXPECT_NEAR(between.y, 0.1, 0.01);
}

TEST_F(TrackedPath, AScanAfterTheLastAnchorIsCarriedFromIt) {
  EXPECT_THAT(all_scans({})[3].pose, IsNear(second_ * Pose2{0.3, 0.0, 0.0}, kExact));
}

TEST_F(TrackedPath, AScanBesideABreakGoesWithTheAnchorOnItsSide) {
  EXPECT_THAT(all_scans({{.time = 1.5, .anchor = 1}})[1].pose,
              IsNear(Pose2{0.5, 0.0, 0.0}, kExact));
  EXPECT_THAT(all_scans({{.time = 0.5, .anchor = 1}})[1].pose,
              IsNear(second_ * Pose2{-0.5, 0.0, 0.0}, kExact));
}

TEST(FusedBeliefs, TheSurerBeliefCountsMore) {
  const PosePrior sure{.mean = {1.0, 0.0, 0.0}, .information = 3.0 * Eigen::Matrix3d::Identity()};
  const PosePrior unsure{.mean = {2.0, 0.4, 0.0}, .information = Eigen::Matrix3d::Identity()};
  const PosePrior both = fused(sure, unsure);
  EXPECT_THAT(both.mean, IsNear(Pose2{1.25, 0.1, 0.0}, Tolerance{1e-12, 1e-12}));
  EXPECT_TRUE(both.information.isApprox(4.0 * Eigen::Matrix3d::Identity()));
}

}  // namespace
}  // namespace mapbed
