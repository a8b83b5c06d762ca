#include "algorithms/scan_matching/match_covariance.h"

#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "algorithms/field/local_map.h"
#include "algorithms/scan/hit_points.h"
#include "algorithms/scan/surface_points.h"
#include "algorithms/scan_matching/scan_matcher.h"
#include "core/geometry/angle.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr double kRangeSigma = 0.01;  // [m]
constexpr int kMaps = 50;
constexpr int kMatchesInAMap = 20;

// A map of ten noisy scans from places about `here`, in a frame of its own.
LikelihoodField field_about(const TestRoom& room, const Pose2& here, const Pose2& frame, Rng& rng) {
  SurfaceMeans means(0.05);
  for (int scan = 0; scan < 10; ++scan) {
    const Pose2 seen_from = here * Pose2{0.2 - 0.4 * scan + rng.uniform(-0.2, 0.2),
                                         rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)};
    const LaserScan past = with_range_noise(scan_of(room, seen_from), kRangeSigma, rng);
    means.add(transformed(surface_points(past, 30.0, 0.2, 0.05), frame * seen_from));
  }
  LikelihoodField field;
  field.add(means.means());
  return field;
}

struct Consistency {
  double mean_nees = 0.0;   // normalised squared error: 3 where the covariance is calibrated
  double mean_along = 0.0;  // the same of the place along x alone: 1
};

// Matches from predictions that are as far off as their prior says.
Consistency consistency_in(const TestRoom& room, const std::vector<Pose2>& places) {
  Rng rng(11);
  Consistency mean;
  for (int map = 0; map < kMaps; ++map) {
    const Pose2 here = places[static_cast<std::size_t>(map) % places.size()];
    const Pose2 frame{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-kPi, kPi)};
    const LikelihoodField field = field_about(room, here, frame, rng);
    for (int i = 0; i < kMatchesInAMap; ++i) {
      const Pose2 in_room =
          here * Pose2{rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), rng.uniform(-0.3, 0.3)};
      const Pose2 truth = frame * in_room;
      const Pose2 off{rng.normal(0.0, 0.05), rng.normal(0.0, 0.05), rng.normal(0.0, 0.03)};
      const PosePrior prediction = independent_prior(truth * inverse(off), 0.05, 0.05, 0.03);
      const LaserScan scan = with_range_noise(scan_of(room, in_room), kRangeSigma, rng);
      const FieldPoints points = to_field_points(hit_points(scan, {}), field.resolution());

      const Pose2 match = match_scan(points, field, prediction).map_from_robot;
      const Eigen::Matrix3d covariance =
          match_information(match, points, field).covariance(prediction.information);

      const Pose2 error = motion_between(match, truth);
      const Eigen::Vector3d e(error.x, error.y, error.theta);
      mean.mean_nees += e.dot(covariance.inverse() * e) / (kMaps * kMatchesInAMap);
      const double heading = in_room.theta - error.theta;  // of the match, in the room
      const Eigen::Vector3d along(std::cos(heading), -std::sin(heading), 0.0);
      mean.mean_along +=
          std::pow(along.dot(e), 2) / along.dot(covariance * along) / (kMaps * kMatchesInAMap);
    }
  }
  return mean;
}

// Of 1000 independent errors the mean would lie within 3 +- 0.16 (two standard errors, sqrt(6/1000)
// each). The bounds leave room for what the errors of a map's walls have in common.
TEST(MatchCovariance, IsCalibratedInARoom) {
  const Consistency result = consistency_in(rectangular_room(6.0, 4.0),
                                            {{1.0, 0.0, 0.0}, {1.5, 0.5, 2.0}, {1.0, 1.0, 1.0}});
  EXPECT_GT(result.mean_nees, 2.0);
  EXPECT_LT(result.mean_nees, 4.5);
}

TEST(MatchCovariance, IsCalibratedInACorridorAlsoAlongIt) {
  const Consistency result =
      consistency_in(corridor(60.0), {{0.0, 0.0, 0.0}, {5.0, 0.2, 0.1}, {-5.0, -0.2, -0.1}});
  EXPECT_GT(result.mean_nees, 2.0);
  EXPECT_LT(result.mean_nees, 4.5);
  EXPECT_GT(result.mean_along, 0.66);
  EXPECT_LT(result.mean_along, 1.5);
}

// The long walls hold the robot across the corridor, nothing holds it along.
TEST(MatchCovariance, IsThatOfThePredictionWhereTheMapSaysNothing) {
  const TestRoom room = corridor(60.0);
  const LaserScan scan = scan_of(room, {});
  LikelihoodField field;
  field.add(surface_points(scan, 30.0, 0.2, 0.05));
  const FieldPoints points = to_field_points(hit_points(scan, {}), field.resolution());
  const PosePrior prediction = independent_prior({}, 0.05, 0.05, 0.03);

  const Eigen::Matrix3d covariance =
      match_information({}, points, field).covariance(prediction.information);

  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 0.05, 0.01);
  EXPECT_LT(std::sqrt(covariance(1, 1)), 0.01);
  const Eigen::Matrix3d nothing_seen =
      match_information({}, {}, field).covariance(prediction.information);
  EXPECT_TRUE(nothing_seen.isApprox(prediction.information.inverse(), 1e-3));
}

// A corridor's scan promises nothing along it, and across as much as its covariance is small.
TEST(MatchInformation, IsThatOfTheScanAlone) {
  const TestRoom room = corridor(60.0);
  Rng rng(5);
  const LikelihoodField field = field_about(room, {}, {}, rng);
  const LaserScan scan = with_range_noise(scan_of(room, {}), kRangeSigma, rng);
  const FieldPoints points = to_field_points(hit_points(scan, {}), field.resolution());
  const Pose2 match =
      match_scan(points, field, independent_prior({}, 0.05, 0.05, 0.03)).map_from_robot;

  const MatchInformation found = match_information(match, points, field);

  const Eigen::Matrix3d information = found.information();
  EXPECT_LT(information(0, 0), 1.0 / (0.3 * 0.3));
  EXPECT_GT(information(1, 1), 1.0 / (0.01 * 0.01));
  // Where a scan says all, both are the same.
  const LikelihoodField of_room = field_about(rectangular_room(6.0, 4.0), {}, {}, rng);
  const LaserScan seen =
      with_range_noise(scan_of(rectangular_room(6.0, 4.0), {}), kRangeSigma, rng);
  const MatchInformation whole =
      match_information({}, to_field_points(hit_points(seen, {}), of_room.resolution()), of_room);
  EXPECT_TRUE(whole.information().inverse().isApprox(whole.covariance(), 0.05));
}

// Ten points at one place before a wall, 2 cm off: their slopes are all the same, so the scatter of
// ten that err together is ten times that of ten that err each by itself.
TEST(MatchCovariance, NeighbouringBeamsErrTogether) {
  std::vector<SurfacePoint> wall;
  for (int i = -100; i <= 100; ++i) wall.push_back({{0.01 * i, 1.0}, {1.0, 0.0}});
  LikelihoodField field;
  field.add(wall);
  const FieldPoints points = to_field_points(
      std::vector<Eigen::Vector2d>(10, Eigen::Vector2d(0.0, 0.98)), field.resolution());
  const auto variance_across = [&](int together) {
    return match_information({}, points, field, {.beams_together = together}).covariance()(1, 1);
  };
  EXPECT_NEAR(variance_across(10) / variance_across(1), 10.0, 0.01);
  EXPECT_NEAR(variance_across(5) / variance_across(1), 5.0, 0.01);
}

}  // namespace
}  // namespace mapbed
