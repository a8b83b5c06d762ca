#include "worlds/geometry/footprint.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kRounding = 1e-9;

Entity of(Geometry geometry, const Pose3& pose = {}) {
  return {.name = "thing",
          .world_from_entity = pose,
          .parts = {{.name = "part", .geometry = std::move(geometry)}}};
}

double nearest(const std::vector<Footprint>& footprints, const Eigen::Vector2d& point) {
  double distance = 1e9;
  for (const Footprint& f : footprints) distance = std::min(distance, distance_to(f, point));
  return distance;
}

TEST(Footprint, OfABoxTurnsWithIt) {
  const auto found = footprints(of(Box{{2, 1, 1}}, upright({5, 0, radians(90)})), 7, -0.1, 0.1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].entity, 7);
  EXPECT_NEAR(distance_to(found[0], {5, 3}), 2.0, kRounding);
  EXPECT_NEAR(distance_to(found[0], {7, 0}), 1.5, kRounding);
  EXPECT_EQ(distance_to(found[0], {5, 0.9}), 0.0);
}

TEST(Footprint, IsNotThereOutsideTheBand) {
  EXPECT_TRUE(footprints(of(Box{{1, 1, 1}}), 0, 0.5, 2.0).empty());
  EXPECT_EQ(footprints(of(Cylinder{1, 1}), 0, 0.4, 2.0).size(), 1u);
}

TEST(Footprint, OfATiltedBoxIsTheSameAsOfItsCutThroughTheBand) {
  // A cube on its edge: at half height it is widest, sqrt(2) / 2 to either side.
  const Pose3 on_edge{{0, 0, 0}, rotation_of(0, 0, radians(45))};
  const auto found = footprints(of(Box{{1, 1, 1}}, on_edge), 0, -0.01, 0.01);
  EXPECT_NEAR(nearest(found, {0, 3}), 3 - std::sqrt(0.5), kRounding);
  EXPECT_NEAR(nearest(found, {3, 0}), 2.5, kRounding);
}

TEST(Footprint, IsFarFromAWayByTheNearestPointOfIt) {
  const auto circle = footprints(of(Cylinder{0.5, 1}), 0, 0, 0.1);
  EXPECT_NEAR(distance_to(circle[0], {-3, 2}, {3, 2}), 1.5, kRounding);
  EXPECT_EQ(distance_to(circle[0], {-3, 0.4}, {3, 0.4}), 0.0);
  const auto box = footprints(of(Box{{1, 1, 1}}), 0, 0, 0.1);
  EXPECT_EQ(distance_to(box[0], {-3, 0}, {3, 0}), 0.0) << "runs through, both ends outside";
  EXPECT_NEAR(distance_to(box[0], {-3, 1}, {3, 1}), 0.5, kRounding);
}

TEST(Footprint, KeepsTheNotchOfAnLFree) {
  const Extrusion l{{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1};
  const auto found = footprints(of(l), 0, 0, 0.1);
  EXPECT_NEAR(distance_to(found[0], {2.5, 2}), 1.0, kRounding);
}

TEST(Footprint, TouchesAnotherWhereOneLiesInTheOther) {
  const auto large = footprints(of(Box{{4, 4, 1}}), 0, 0, 0.1)[0];
  const auto small = footprints(of(Cylinder{0.1, 1}), 0, 0, 0.1)[0];
  EXPECT_EQ(distance_between(large, small), 0.0);
  EXPECT_EQ(distance_between(small, large), 0.0);
  const auto aside = footprints(of(Box{{1, 1, 1}}, upright({4, 0, 0})), 0, 0, 0.1)[0];
  EXPECT_NEAR(distance_between(large, aside), 1.5, kRounding);
}

}  // namespace
}  // namespace mapbed
