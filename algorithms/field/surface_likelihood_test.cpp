#include "algorithms/field/surface_likelihood.h"

#include <cmath>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/scan/surface_points.h"
#include "core/geometry/angle.h"
#include "core/testing/is_near.h"
#include "core/testing/test_room.h"

namespace mapbed {
namespace {

constexpr double kResolution = 0.1;  // [m]

ScanForWeighting seen_from(const TestRoom& room, const Pose2& pose) {
  return scan_for_weighting(scan_of(room, pose), {.min_spacing = 0.1, .max_points = 90}, {},
                            kResolution);
}

// What two scans in the middle of the room saw.
SurfaceMap map_of(const TestRoom& room) {
  SurfaceMap map(kResolution);
  for (const Pose2 pose : {Pose2{0, 0, 0}, Pose2{0.1, 0, kPi}}) {
    map.add(seen_from(room, pose).surface, pose);
  }
  return map;
}

// As it stands in the header, one point after the other.
double plain_log_likelihood(const ScanForWeighting& scan, const SurfaceMap& map, const Pose2& pose,
                            const SurfaceLikelihoodOptions& options) {
  double sum = 0.0;
  for (const Eigen::Vector2d& hit : scan.hits) {
    const SurfaceMap::Nearest nearest = map.nearest(pose * hit);
    const Eigen::Vector2d off(double{nearest.off_x}, double{nearest.off_y});
    const Eigen::Vector2d line = tangent_of({double{nearest.doubled_x}, double{nearest.doubled_y}});
    const double along = off.dot(line);
    const double squared = off.squaredNorm() - (1.0 - 0.1 * 0.1) * along * along;
    const double gauss =
        nearest.found ? std::exp(-0.5 * squared / (options.sigma * options.sigma)) : 0.0;
    sum += std::log(options.inlier_ratio * gauss + 1.0 - options.inlier_ratio);
  }
  return options.beam_weight * sum;
}

TEST(SurfaceLikelihood, IsThePlainSumOverThePoints) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const SurfaceMap map = map_of(room);
  const SurfaceLikelihoodOptions options;
  const SurfaceLikelihood likelihood(options);
  for (const Pose2 pose : {Pose2{0.3, 0.2, 0.4}, Pose2{-1.0, 0.5, 2.0}}) {
    const ScanForWeighting scan = seen_from(room, pose);
    for (const Pose2 off : {Pose2{}, Pose2{0.05, -0.03, 0.02}, Pose2{0.3, 0.2, -0.2}}) {
      // The table is linear over steps of 1/32 in d^2 / sigma^2: 1e-5 off for each of 90 beams. A
      // Gaussian beyond four sigma is left out: at most 2e-3 for each.
      EXPECT_NEAR(likelihood.log_likelihood(scan, map, pose * off),
                  plain_log_likelihood(scan, map, pose * off, options), 0.02);
    }
  }
}

TEST(SurfaceLikelihood, WhatAMissingReturnPassedThroughMustBeFree) {
  SurfaceMap map(kResolution);
  map.add({{{7.85, 0.0}}}, Pose2{});
  const SurfaceLikelihoodOptions options{.beam_weight = 1.0};
  LaserScan scan{.first_bearing = 0.0, .bearing_step = 0.1, .max_range = 8.0};
  scan.ranges = {8.0};
  const auto log_likelihood = [&](const Pose2& pose) {
    return SurfaceLikelihood(options).log_likelihood(
        scan_for_weighting(scan, {}, options, kResolution), map, pose);
  };
  const double contradiction = std::log(1.0 - options.inlier_ratio);
  EXPECT_NEAR(log_likelihood({}), contradiction, 1e-6);  // 0.15 m before the beam's end
  EXPECT_EQ(log_likelihood({0.0, 0.5, 0.0}), 0.0);       // beside it
  EXPECT_EQ(log_likelihood({-0.4, 0.0, 0.0}), 0.0);      // behind the beam's end
  scan.max_range = scan.ranges[0] =
      options.no_return_range + 1.0;  // a glass pane may be the reason
  EXPECT_EQ(log_likelihood({8.0 - scan.max_range, 0.0, 0.0}), 0.0);
}

// Weights of beams, in a room of which two beams see nothing: these must pass through what is free.
class BeamWeights : public ::testing::Test {
 protected:
  static LaserScan seen() {
    LaserScan scan = scan_of(rectangular_room(6.0, 4.0), {0.3, 0.2, 0.4});
    scan.max_range = 8.0;
    for (const std::size_t beam : {10, 40}) scan.ranges[beam] = 8.0;
    return scan;
  }
  ScanForWeighting weighted(const LaserScan& scan, const std::vector<float>& weights = {}) const {
    return scan_for_weighting(scan, points_, {}, kResolution, weights);
  }

  // Something stands where the two beams end.
  static SurfaceMap map() {
    SurfaceMap map = map_of(rectangular_room(6.0, 4.0));
    const LaserScan scan = seen();
    for (const std::size_t beam : {10, 40}) {
      const double bearing = scan.bearing(beam);
      map.add({{7.8 * Eigen::Vector2d(std::cos(bearing), std::sin(bearing))}}, {0.3, 0.2, 0.4});
    }
    return map;
  }

  const HitPointOptions points_{.min_spacing = 0.01, .max_points = 10'000};
  const Pose2 pose_ = Pose2{0.3, 0.2, 0.4} * Pose2{0.05, -0.03, 0.02};
  const SurfaceMap map_ = map();
  const SurfaceLikelihood likelihood_;
};

TEST_F(BeamWeights, OfAHalfCountHalf) {
  const LaserScan scan = seen();
  const std::vector<float> halves(scan.ranges.size(), 0.5F);
  const double whole = likelihood_.log_likelihood(weighted(scan), map_, {0.3, 0.2, 0.4});
  EXPECT_LT(whole, 0.1 * 1.9 * std::log(0.15)) << "both beams without a return contradict the map";
  for (const Pose2& pose : {Pose2{0.3, 0.2, 0.4}, pose_}) {
    EXPECT_NEAR(likelihood_.log_likelihood(weighted(scan, halves), map_, pose),
                0.5 * likelihood_.log_likelihood(weighted(scan), map_, pose), 1e-9);
    EXPECT_NEAR(likelihood_.inlier_ratio(weighted(scan, halves), map_, pose),
                likelihood_.inlier_ratio(weighted(scan), map_, pose), 1e-9);
  }
}

TEST_F(BeamWeights, TwoHalvesAtOnePlaceCountAsOne) {
  const ScanForWeighting whole = weighted(seen());
  ScanForWeighting halves{.surface = whole.surface};
  for (const Eigen::Vector2d& hit : whole.hits) halves.hits.insert(halves.hits.end(), {hit, hit});
  for (const Eigen::Vector2d& end : whole.free) halves.free.insert(halves.free.end(), {end, end});
  halves.hit_weights.assign(halves.hits.size(), 0.5F);
  halves.free_weights.assign(halves.free.size(), 0.5F);
  EXPECT_NEAR(likelihood_.log_likelihood(halves, map_, pose_),
              likelihood_.log_likelihood(whole, map_, pose_), 1e-9);
  const PosePrior prior = independent_prior(pose_, 0.05, 0.05, 0.03);
  const LocalPosterior of_whole = likelihood_.local_posterior(pose_, whole, map_, prior);
  const LocalPosterior of_halves = likelihood_.local_posterior(pose_, halves, map_, prior);
  EXPECT_THAT(of_halves.mode, IsNear(of_whole.mode, Tolerance{1e-4, 1e-4}));
  EXPECT_NEAR(of_halves.log_evidence, of_whole.log_evidence, 1e-3);  // sums of floats
}

TEST_F(BeamWeights, OfNothingAreAsABeamThatIsNotThere) {
  const LaserScan scan = seen();
  LaserScan without = scan;
  std::vector<float> weights(scan.ranges.size(), 1.0F);
  for (std::size_t beam = 8; beam < 20; ++beam) {
    weights[beam] = 0.0F;
    without.ranges[beam] = 0.0;  // failed
  }
  EXPECT_NEAR(likelihood_.log_likelihood(weighted(scan, weights), map_, pose_),
              likelihood_.log_likelihood(weighted(without), map_, pose_), 1e-9);
}

// The posterior that is drawn from, against sums over a lattice of poses (Grisetti et al. 2007).
class LocalPosteriorOf : public ::testing::TestWithParam<Pose2> {};

TEST_P(LocalPosteriorOf, AScanHasModeCovarianceAndEvidenceOfTheWholeDensity) {
  const TestRoom room = rectangular_room(6.0, 4.0);
  const SurfaceMap map = map_of(room);
  const Pose2 truth{0.4, -0.3, 0.2};
  const ScanForWeighting scan = seen_from(room, truth);
  const SurfaceLikelihoodOptions options{.beam_weight = 0.1, .proposal_weight = 0.1};
  const SurfaceLikelihood likelihood(options);
  const PosePrior prior = independent_prior(truth * GetParam(), 0.05, 0.05, 0.03);

  const LocalPosterior found = likelihood.local_posterior(prior.mean, scan, map, prior);

  const auto log_density = [&](const Pose2& x) {
    return likelihood.log_likelihood(scan, map, x) + prior.log_at(x);
  };
  const Eigen::Vector3d step = 0.6 * found.covariance.diagonal().cwiseSqrt();
  double sum = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int i = -7; i <= 7; ++i) {
    for (int j = -7; j <= 7; ++j) {
      for (int k = -7; k <= 7; ++k) {
        const Eigen::Vector3d e = Eigen::Vector3d(i, j, k).cwiseProduct(step);
        const double density = std::exp(log_density(found.mode * Pose2{e.x(), e.y(), e.z()}) -
                                        log_density(found.mode));
        sum += density;
        mean += density * e;
        squares += density * e * e.transpose();
      }
    }
  }
  mean /= sum;
  const Eigen::Matrix3d scatter = squares / sum - mean * mean.transpose();
  for (int i = 0; i < 3; ++i) {
    const double sigma = std::sqrt(found.covariance(i, i));
    EXPECT_LT(std::abs(mean(i)), 0.3 * sigma) << "of coordinate " << i;
    // Tails heavier than the Gaussian's, as hits may be explained by chance.
    EXPECT_NEAR(scatter(i, i) / found.covariance(i, i), 1.1, 0.25) << "of coordinate " << i;
  }
  // Up to the constant (2 pi)^(3/2) of the Gaussian's integral.
  const double log_integral = log_density(found.mode) + std::log(sum * step.prod());
  EXPECT_NEAR(found.log_evidence + 1.5 * std::log(2.0 * kPi), log_integral, 0.25);
}

INSTANTIATE_TEST_SUITE_P(SurfaceLikelihood, LocalPosteriorOf,
                         ::testing::Values(Pose2{}, Pose2{0.04, 0.0, 0.0}, Pose2{0.0, -0.04, 0.0},
                                           Pose2{0.0, 0.0, 0.03}, Pose2{-0.03, 0.03, -0.02}));

TEST(SurfaceLikelihood, WithoutHitsThePosteriorIsThePrior) {
  const PosePrior prior = independent_prior({1.0, 2.0, 0.5}, 0.1, 0.2, 0.05);
  const LocalPosterior found = SurfaceLikelihood().local_posterior(
      prior.mean * Pose2{0.1, 0.1, 0.0}, {}, SurfaceMap(kResolution), prior);
  EXPECT_THAT(found.mode, IsNear(prior.mean, Tolerance{1e-6, 1e-6}));
  EXPECT_NEAR(found.covariance(0, 0), 0.01, 1e-6);
  EXPECT_NEAR(found.covariance(1, 1), 0.04, 1e-6);
}

}  // namespace
}  // namespace mapbed
