#include "algorithms/scan/footprint_weights.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace mapbed {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSigma = 0.06, kMaxRange = 80.0, kMaxGap = 0.2;  // [m]

// Beams of 1 degree about straight ahead, at a wall that stands `distance` [m] ahead and is turned
// by `slant` [rad] from facing the laser.
LaserScan scan_of_wall(double distance, double slant, int beams = 41) {
  LaserScan scan{
      .first_bearing = -0.5 * (beams - 1) * kDegree, .bearing_step = kDegree, .max_range = 100.0};
  for (int i = 0; i < beams; ++i) {
    const double bearing = scan.bearing(static_cast<std::size_t>(i));
    scan.ranges.push_back(distance * std::cos(slant) / std::cos(bearing - slant));
  }
  return scan;
}

// sigma^2 over itself and the variance of a uniform error over the arc between two beams.
double weight_by_hand(double range, double cosine) {
  const double error = range * kDegree * cosine;
  return kSigma * kSigma / (kSigma * kSigma + error * error / 12.0);
}

TEST(FootprintWeights, AreFullWhereTheSurfaceFacesTheBeamHoweverFar) {
  const std::vector<float> weights =
      footprint_weights(scan_of_wall(30.0, 0.0, 11), kMaxRange, kMaxGap, kSigma);
  EXPECT_NEAR(weights[5], 1.0, 1e-5);
}

TEST(FootprintWeights, FallAsTheErrorAcrossTheBeamMovesTheEndOffASlantedSurface) {
  const double slant = 45.0 * kDegree;
  const std::vector<float> weights =
      footprint_weights(scan_of_wall(20.0, slant, 11), kMaxRange, kMaxGap, kSigma);
  EXPECT_NEAR(weights[5], weight_by_hand(20.0, std::cos(slant)), 1e-4);
}

TEST(FootprintWeights, OfAHitOnNoLineFallWithItsRangeAlone) {
  LaserScan scan = scan_of_wall(10.0, 0.0, 5);
  for (double& range : scan.ranges) range = 100.0;  // nothing was hit
  scan.ranges[2] = 40.0;
  EXPECT_NEAR(footprint_weights(scan, kMaxRange, kMaxGap, kSigma)[2], weight_by_hand(40.0, 1.0),
              1e-6);
  scan.ranges[2] = 1.0;
  EXPECT_NEAR(footprint_weights(scan, kMaxRange, kMaxGap, kSigma)[2], weight_by_hand(1.0, 1.0),
              1e-6);
}

TEST(FootprintWeights, DoNotDependOnHowTheLaserIsMounted) {
  LaserScan scan = scan_of_wall(15.0, 0.5);
  const std::vector<float> ahead = footprint_weights(scan, kMaxRange, kMaxGap, kSigma);
  scan.robot_from_laser.planar = {0.3, -0.2, 2.0};
  const std::vector<float> turned = footprint_weights(scan, kMaxRange, kMaxGap, kSigma);
  for (std::size_t i = 0; i < ahead.size(); ++i) EXPECT_NEAR(turned[i], ahead[i], 1e-5) << i;
}

TEST(FootprintWeights, OfBeamsThatEachHaveTheirPlaceAreByTheirOwnDirections) {
  LaserScan scan = scan_of_wall(15.0, 0.5);
  const std::vector<float> of_one_place = footprint_weights(scan, kMaxRange, kMaxGap, kSigma);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    scan.robot_from_beams.push_back({0.0, 0.0, scan.bearing(i)});
  }
  scan.robot_from_laser.planar = {0.0, 0.0, 1.0};  // no longer counts
  const std::vector<float> of_many = footprint_weights(scan, kMaxRange, kMaxGap, kSigma);
  for (std::size_t i = 0; i < of_many.size(); ++i) EXPECT_NEAR(of_many[i], of_one_place[i], 1e-5);
}

}  // namespace
}  // namespace mapbed
