#include "algorithms/submaps/loop_closer.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

// By drawing poses of the window: no less than the share in the ellipsoid of all three, no more
// than the share in the box about it.
TEST(ChanceWithin, IsTheShareOfTheWindowInTheRegionOfPositionAndOfHeading) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() << 1.0, 0.4, 0.4, 0.5;
  covariance(2, 2) = 0.1 * 0.1;
  constexpr double kQuantile = 9.0, kWindow = 8.0, kTurnWindow = 0.6;
  Rng rng(3);
  int in_window = 0, in_region = 0, in_ellipsoid = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Eigen::Vector3d pose(rng.uniform(-kWindow, kWindow), rng.uniform(-kWindow, kWindow),
                               rng.uniform(-kTurnWindow, kTurnWindow));
    const Eigen::Vector2d place = pose.head<2>();
    if (place.norm() > kWindow) continue;
    ++in_window;
    const double of_place = place.dot(covariance.topLeftCorner<2, 2>().inverse() * place);
    in_region += of_place <= kQuantile && std::abs(pose.z()) <= 3.0 * 0.1;
    in_ellipsoid += pose.dot(covariance.inverse() * pose) <= kQuantile;
  }
  const double chance = chance_within(covariance, kQuantile, kWindow, kTurnWindow);
  EXPECT_NEAR(chance, static_cast<double>(in_region) / in_window, 0.002);
  EXPECT_GT(chance, static_cast<double>(in_ellipsoid) / in_window);
}

TEST(ChanceWithin, IsOneWhereTheRegionSaysNothing) {
  EXPECT_EQ(chance_within(100.0 * Eigen::Matrix3d::Identity(), 11.3, 15.0, 3.1), 1.0);
  // A heading that is known well says something by itself.
  const Eigen::Matrix3d heading_only = Eigen::Vector3d(100.0, 100.0, 1e-4).asDiagonal();
  EXPECT_NEAR(chance_within(heading_only, 9.0, 15.0, 3.0), 0.01, 1e-12);
}

}  // namespace
}  // namespace mapbed
