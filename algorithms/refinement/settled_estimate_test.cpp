#include "algorithms/refinement/settled_estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

const Tolerance kExact{1e-6, 1e-6};

// Two updates 1 m apart by odometry and scan matching, and two scans beside them; the laser sees
// nothing. The particles have the second update elsewhere.
class SettledEstimate : public ::testing::Test {
 protected:
  SettledPath path(const std::vector<Break>& breaks, int rounds) const {
    return settled_path({{}, second_}, updates_, scans_, breaks, {}, {.rounds = rounds});
  }
  Trajectory all_scans(const std::vector<Break>& breaks) const {
    return with_scans_between(path(breaks, 0), updates_, between_, std::vector<KeptHits>(4), breaks,
                              {}, {});
  }

  const Pose2 second_{1.0, 0.2, 0.0};
  const std::vector<ScanCondenser::Update> updates_{
      {.time = 0.0}, {.time = 2.0, .seen_from_robot = {1.0, 0.0, 0.0}}};
  const std::vector<ScanForWeighting> scans_ = std::vector<ScanForWeighting>(2);
  const std::vector<ScanCondenser::Scan> between_{
      {.time = 0.0, .seen_from_robot = {}, .updates = 1, .is_update = true},
      {.time = 1.0, .seen_from_robot = {0.5, 0.0, 0.0}, .updates = 1},
      {.time = 2.0, .seen_from_robot = {1.0, 0.0, 0.0}, .updates = 2, .is_update = true},
      {.time = 3.0, .seen_from_robot = {1.3, 0.0, 0.0}, .updates = 2}};
};

TEST_F(SettledEstimate, FollowsTheMotionsThatWereSeen) {
  EXPECT_THAT(path({}, 1).poses[1], IsNear(Pose2{1.0, 0.0, 0.0}, kExact));
}

TEST_F(SettledEstimate, AcrossABreakTheFilterAloneSaysHowPlacesLie) {
  EXPECT_THAT(path({{.time = 1.0, .update = 1}}, 5).poses[1], IsNear(second_, kExact));
}

TEST_F(SettledEstimate, ScansOfUpdatesLieWhereTheirUpdatesDo) {
  const Trajectory trajectory = all_scans({});
  ASSERT_EQ(trajectory.size(), 4U);
  EXPECT_EQ(trajectory[0].pose, Pose2{});
  EXPECT_EQ(trajectory[2].pose, second_);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(trajectory[i].time, between_[i].time);
}

TEST_F(SettledEstimate, AScanBetweenUpdatesLiesBetweenWhatBothSay) {
  // (0.5, 0) from before, (0.5, 0.2) from after, with the same spread.
  const Pose2 between = all_scans({})[1].pose;
  EXPECT_NEAR(between.x, 0.5, 0.02);
  EXPECT_NEAR(between.y, 0.1, 0.01);
}

TEST_F(SettledEstimate, AScanAfterTheLastUpdateIsCarriedFromIt) {
  EXPECT_THAT(all_scans({})[3].pose, IsNear(second_ * Pose2{0.3, 0.0, 0.0}, kExact));
}

TEST_F(SettledEstimate, AScanBesideABreakGoesWithTheUpdateOnItsSide) {
  EXPECT_THAT(all_scans({{.time = 1.5, .update = 1}})[1].pose,
              IsNear(Pose2{0.5, 0.0, 0.0}, kExact));
  EXPECT_THAT(all_scans({{.time = 0.5, .update = 1}})[1].pose,
              IsNear(second_ * Pose2{-0.5, 0.0, 0.0}, kExact));
}

TEST(ScansBetweenUpdates, AreMatchedWithTheMapOfThePath) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const auto seen_at = [&](const Pose2& pose) {
    return scan_for_weighting(scan_of(room, pose), {}, {}, 0.1);
  };
  const Pose2 start{-0.5, 0.2, 0.1}, truth{-0.2, 0.3, 0.15};
  const SettledPath path = settled_path({start}, {{}}, {seen_at(start)}, {}, {}, {});
  KeptHits hits;
  for (const Eigen::Vector2d& hit : seen_at(truth).hits) hits.push_back(hit.cast<float>());
  // The motion that was seen is 6 cm too long; motions are held to be right to 5 cm, the scan to
  // 1 or 2: it leaves a tenth of the error at most.
  const Pose2 seen = motion_between(start, truth) * Pose2{0.06, 0.0, 0.0};
  const Trajectory trajectory = with_scans_between(
      path, {{}},
      {{.updates = 1, .is_update = true}, {.time = 1.0, .seen_from_robot = seen, .updates = 1}},
      {{}, hits}, {}, {}, {});
  EXPECT_THAT(trajectory[1].pose, IsNear(truth, Tolerance{0.015, 0.015}));
}

}  // namespace
}  // namespace mapbed
