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

// Free ground of 2 m x 3 m but for a wall along y = 1 m, cells of 5 cm; the wall's centres lie at
// y = 1.025 m.
OccupancyMap wall() {
  OccupancyMap map(0.05);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 40; ++x) map.at({x, y}) = known(y == 20 ? 1.0 : 0.0);
  }
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

TEST(EndPointTable, WhatIsFarFromWallsOnKnownGroundIsAnOutlier) {
  const EndPointTable table(wall(), kSigma, kInlierRatio);
  const float outlier = static_cast<float>(std::log(1 - kInlierRatio));
  EXPECT_FLOAT_EQ(table.log_at({1.0, 0.3}), outlier);
  EXPECT_FLOAT_EQ(table.log_at({1.0, 2.9}), outlier);
}

TEST(EndPointTable, TellsWhatEndsWhereNothingIsKnown) {
  const EndPointTable table(wall(), kSigma, kInlierRatio);
  const float outlier = static_cast<float>(std::log(1 - kInlierRatio));
  // On the wall; beside it, where nothing is known; beyond the map, twice.
  const FieldPoints points = to_field_points(
      {{1.025, 1.025}, {2.025, 1.025}, {1.0, 3.2}, {-1e6, 1.025}}, 0.05, {1.0F, 1.0F, 1.0F, 0.5F});
  const EndPointTable::Told told = table.told({}, points);
  EXPECT_EQ(told.weight, 2.0);
  EXPECT_NEAR(told.log, std::log(kInlierRatio * std::exp(-0.125) + 1 - kInlierRatio), 1e-3);
  EXPECT_NEAR(table.sum({}, points), told.log + 1.5 * double{outlier}, 1e-4);
  EXPECT_EQ(EndPointTable(OccupancyMap(0.05), kSigma, kInlierRatio).told({}, points).weight, 0.0);
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
