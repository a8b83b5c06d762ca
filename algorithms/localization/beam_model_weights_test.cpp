#include "algorithms/localization/beam_model_weights.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/test_room.h"

namespace mapbed {
namespace {

// Free ground with walls, a cell thick, at x = 2 m and at x = 4 m; cells of 5 cm, and their centres
// at 2.025 m and 4.025 m.
FreeSpace two_walls() {
  OccupancyMap map(0.05);
  for (int y = -60; y < 60; ++y) {
    for (int x = -20; x < 100; ++x) map.at({x, y}) = known(x == 40 || x == 80 ? 1.0 : 0.0);
  }
  return FreeSpace(std::make_shared<OccupancyMap>(map));
}

// Twenty beams within a degree along x, that all ended after `range` [m].
LaserScan scan_along_x(double range) {
  return {.first_bearing = -0.01,
          .bearing_step = 0.001,
          .max_range = 20.0,
          .ranges = std::vector<double>(20, range)};
}

double log_weight(double range, const LaserWeightOptions& options) {
  const auto weights = make_laser_weights(options, two_walls(), Rng(1));
  EXPECT_TRUE(weights->take(scan_along_x(range), {}));
  double log = 0.0;
  const Pose2 robot{0.0, 0.0, 0.0};
  weights->add_log_weights({&robot, 1}, {&log, 1});
  return log;
}

LaserWeightOptions options(LaserModel model) {
  return {.model = model,
          .beam_weight = 1.0 / 20.0,
          .points = {.max_range = 30.0, .min_spacing = 0.0, .max_points = 20}};
}

TEST(BeamModelWeights, ABeamEndsAtTheFirstWallOrBeforeItAndSeldomBehind) {
  const LaserWeightOptions beam = options(LaserModel::beam);
  const double w = beam.inlier_ratio;
  EXPECT_NEAR(log_weight(2.025, beam), 0.0, 0.01);
  EXPECT_NEAR(log_weight(2.125, beam), std::log(w * std::exp(-0.5) + 1.0 - w), 0.01);
  EXPECT_NEAR(log_weight(1.0, beam), std::log(1.0 - w), 1e-9);
  EXPECT_NEAR(log_weight(3.0, beam), std::log(beam.through_wall * (1.0 - w)), 1e-9);
}

TEST(BeamModelWeights, EndPointsAloneTakeTheWallBehindForThisOne) {
  EXPECT_NEAR(log_weight(4.025, options(LaserModel::likelihood_field)), 0.0, 0.01);
  EXPECT_LT(log_weight(4.025, options(LaserModel::beam)), -4.0);
}

TEST(LaserWeights, WhatABeamIsWorthScalesItsTerm) {
  for (const LaserModel model : {LaserModel::likelihood_field, LaserModel::beam}) {
    const auto weights = make_laser_weights(options(model), two_walls(), Rng(1));
    const std::vector<float> half(20, 0.6F);
    ASSERT_TRUE(weights->take(scan_along_x(1.0), half));
    double log = 0.0;
    const Pose2 robot{0.0, 0.0, 0.0};
    weights->add_log_weights({&robot, 1}, {&log, 1});
    EXPECT_NEAR(log, 0.6 * log_weight(1.0, options(model)), 1e-6);
    EXPECT_FALSE(weights->take(scan_along_x(1.0), std::vector<float>(20, 0.0F)));
  }
}

}  // namespace
}  // namespace mapbed
