#include "algorithms/localization/end_point_table.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kSigma = 0.1, kInlierRatio = 0.85;

// A wall along y = 1 m from x = 0 to 2 m, cells of 5 cm; its cells' centres lie at y = 1.025 m.
OccupancyMap wall() {
  OccupancyMap map(0.05);
  for (int x = 0; x < 40; ++x) map.at({x, 20}) = known(1.0);
  for (int x = 0; x < 40; ++x) map.at({x, 5}) = known(0.0);
  return map;
}

FieldPoints random_points(std::size_t count, Rng& rng, bool weighted) {
  FieldPoints points;
  for (std::size_t i = 0; i < count; ++i) {
    points.x.push_back(static_cast<float>(rng.uniform(-200.0, 200.0)));
    points.y.push_back(static_cast<float>(rng.uniform(-200.0, 200.0)));
    if (weighted) points.weights.push_back(static_cast<float>(rng.uniform()));
  }
  return points;
}

TEST(EndPointTable, IsTheMixtureOfTheDistanceToTheNearestOccupiedCell) {
  const EndPointTable table(wall(), kSigma, kInlierRatio);
  for (const int cells : {0, 1, 2, 4, 5}) {
    const double d = 0.05 * cells;
    const double expected =
        std::log(kInlierRatio * std::exp(-d * d / (2 * kSigma * kSigma)) + 1 - kInlierRatio);
    EXPECT_NEAR(table.log_at({1.025, 1.025 - d}), expected, 1e-3) << d;
  }
}

TEST(EndPointTable, WhatIsFarFromWallsOrOutsideTheMapIsAnOutlier) {
  const EndPointTable table(wall(), kSigma, kInlierRatio);
  const float outlier = static_cast<float>(std::log(1 - kInlierRatio));
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(1.0, 0.3), Eigen::Vector2d(1.0, 90.0),
                                       Eigen::Vector2d(-1e6, 1.025), Eigen::Vector2d(1e9, -1e9)}) {
    EXPECT_FLOAT_EQ(table.log_at(point), outlier) << point.transpose();
  }
  EXPECT_FLOAT_EQ(EndPointTable(OccupancyMap(0.05), kSigma, kInlierRatio).log_at({0, 0}), outlier);
}

TEST(EndPointTable, GivesTheBytesOfThePlainSumForAnyProcessorAndNumberOfThreads) {
  const EndPointTable table(wall(), kSigma, kInlierRatio);
  Rng rng(1);
  std::vector<Pose2> poses;
  for (int i = 0; i < 3000; ++i) {
    poses.push_back({rng.uniform(-3, 5), rng.uniform(-3, 5), rng.uniform(-kPi, kPi)});
  }
  for (const bool weighted : {false, true}) {
    const FieldPoints points = random_points(90, rng, weighted);
    std::vector<float> plain;
    for (const Pose2& pose : poses) plain.push_back(table.sum(pose, points));
    for (const Processor processor : {Processor::any, this_processor()}) {
      for (const std::size_t threads : {1, 2, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<float> sums(poses.size());
        table.sums(poses, points, sums, processor);
        EXPECT_EQ(sums, plain);
      }
    }
  }
}

}  // namespace
}  // namespace mapbed
