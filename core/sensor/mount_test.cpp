#include "core/sensor/mount.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/pose3.h"

namespace mapbed {
namespace {

TEST(Mount, TiltsTheBeamsThatLookAhead) {
  // A laser that looks to the robot's left and 30 degrees down: a point 2 m ahead of it lies
  // 2 cos 30 = 1.732 m to the left and 2 sin 30 = 1 m below it.
  const Mount mount{
      .planar = {0.1, 0.2, std::numbers::pi / 2}, .z = 1.5, .pitch = std::numbers::pi / 6};
  const Eigen::Vector3d point = mount.pose() * Eigen::Vector3d(2.0, 0.0, 0.0);
  EXPECT_NEAR(point.x(), 0.1, 1e-12);
  EXPECT_NEAR(point.y(), 0.2 + std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(point.z(), 0.5, 1e-12);
}

TEST(Mount, IsLevelWhateverItsHeightAndHeading) {
  EXPECT_TRUE((Mount{.planar = {0.1, 0.2, 3.0}, .z = 2.0}.is_level()));
  EXPECT_FALSE((Mount{.pitch = 0.01}.is_level()));
  EXPECT_FALSE((Mount{.roll = -0.01}.is_level()));
}

}  // namespace
}  // namespace mapbed
