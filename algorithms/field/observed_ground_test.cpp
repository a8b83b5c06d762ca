#include "algorithms/field/observed_ground.h"

#include <gtest/gtest.h>

#include "algorithms/scan/surface_points.h"
#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

const TestLaser kAllRound{.beams = 360, .first_bearing = -kPi, .max_range = 8.0};

// What a robot in the middle of `room` knows of it.
struct KnownGround {
  explicit KnownGround(const TestRoom& room, const Pose2& pose = {},
                       const TestLaser& laser_model = kAllRound)
      : laser(pose.position()) {
    const LaserScan scan = scan_of(room, pose, laser_model, 0.0);
    map.add(transformed(surface_points(scan, 30.0, 0.2, map.resolution()), pose));
    outline = ObservedGround::outline_of(scan, 30.0, pose);
    ground.add(outline);
  }
  bool knows_about(double x, double y) const { return ground.knows_about({x, y}, laser, map); }

  LikelihoodField map;
  ObservedGround ground;
  ObservedGround::Outline outline;
  Eigen::Vector2d laser;
};

TEST(ObservedGround, IsKnownAboutTheMiddleOfAWallAndNotPastItsEnd) {
  const KnownGround corridor{mapbed::corridor(60.0)};  // 2 m wide
  EXPECT_TRUE(corridor.knows_about(0.0, 1.0));
  EXPECT_TRUE(corridor.knows_about(4.0, -1.0));
  // The laser reaches 8 m: 7.9 m along the walls.
  EXPECT_FALSE(corridor.knows_about(7.9, 1.0));
  EXPECT_FALSE(corridor.knows_about(9.0, 1.0));
  EXPECT_FALSE(corridor.knows_about(-9.0, -1.0));
}

TEST(ObservedGround, IsKnownAboutAPostInTheOpen) {
  TestRoom room = rectangular_room(14.0, 14.0);
  room.add_box({3.0, 1.0}, 0.1, 0.1);
  EXPECT_TRUE(KnownGround{room}.knows_about(2.95, 1.0));
}

// A hit on something new, where nothing stood, is news of the world and speaks against every pose
// alike.
TEST(ObservedGround, IsKnownWhereNothingStood) {
  EXPECT_TRUE(KnownGround{rectangular_room(14.0, 14.0)}.knows_about(3.0, 1.0));
}

// The beam would have gone through the wall.
TEST(ObservedGround, KnowsThatNoBeamReachesGroundBehindAWall) {
  const KnownGround room{rectangular_room(6.0, 6.0)};
  EXPECT_TRUE(room.knows_about(3.25, 0.0));
  EXPECT_TRUE(room.knows_about(4.0, 0.5));
  EXPECT_TRUE(room.knows_about(-9.0, 4.0));
}

TEST(ObservedGround, IsNotKnownInTheShadowOfWhatStandsThere) {
  TestRoom room = rectangular_room(14.0, 14.0);
  room.add_box({3.0, 0.0}, 0.1, 1.0);
  const KnownGround from_middle{room};
  EXPECT_FALSE(from_middle.ground.knows_about({5.0, 0.0}, {5.0, 6.0}, from_middle.map));
}

// 7.1 m along a wall 1 m off, the next beam of a laser with 1 degree passes 13 cm from the wall: it
// does not tell whether the wall goes on.
TEST(ObservedGround, OfOneBeamOfTwoIsNone) {
  const ObservedGround::Outline outline = ObservedGround::outline_of(
      {.bearing_step = kPi / 2, .max_range = 10.0, .ranges = {2.0, 5.0}}, 30.0, {});
  for (const Eigen::Vector2d& corner : outline) EXPECT_LE(corner.norm(), 2.0 + 1e-9);
}

TEST(ObservedGround, IsForgottenWithItsScan) {
  KnownGround room{rectangular_room(14.0, 14.0)};
  room.ground.add(room.outline);
  room.ground.remove(room.outline);
  EXPECT_TRUE(room.knows_about(3.0, 1.0));
  room.ground.remove(room.outline);
  EXPECT_FALSE(room.knows_about(3.0, 1.0));
}

}  // namespace
}  // namespace mapbed
