#include "algorithms/grid/beam_likelihood.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

// Cells (0, 0), (1, 0), ... of 0.5 m with these m.
OccupancyMap row_of(const std::vector<double>& m) {
  OccupancyMap map(0.5);
  for (int x = 0; x < static_cast<int>(m.size()); ++x) {
    map.at({x, 0}) = known(m[static_cast<std::size_t>(x)]);
  }
  return map;
}

// From the border of the row's first cell to the centre of a cell, or through `cells` cells.
Beam beam_into(int cell) {
  return {{0.0, 0.25}, {0.5 * cell + 0.25, 0.25}};
}
Beam beam_through(int cells) {
  return {{0.0, 0.25}, {0.5 * cells, 0.25}, /*hit=*/false};
}

TEST(BeamLikelihood, IsTheProductOfAFreePathAndAReflectingEnd) {  // (2.14)
  const OccupancyMap map = row_of({0.1, 0.2, 0.3, 0.7});
  EXPECT_NEAR(std::exp(log_likelihood(beam_into(3), map)), 0.9 * 0.8 * 0.7 * 0.7, 1e-7);
}

TEST(BeamLikelihood, OfAMaximumRangeBeamIsThatOfItsPathAlone) {  // zeta = 1 in (2.14)
  const OccupancyMap map = row_of({0.1, 0.2, 0.3, 0.7});
  EXPECT_NEAR(std::exp(log_likelihood(beam_through(3), map)), 0.9 * 0.8 * 0.7, 1e-7);
}

TEST(BeamLikelihood, SumsToOneOverAllThatABeamCanDo) {
  const OccupancyMap map = row_of({0.02, 0.3, 0.001, 0.5, 0.9, 0.07});
  for (const bool length_weighted : {false, true}) {
    const BeamLikelihoodOptions options{.length_weighted = length_weighted};
    double sum = std::exp(log_likelihood(beam_through(6), map, options));
    for (int cell = 0; cell < 6; ++cell) {
      sum += std::exp(log_likelihood(beam_into(cell), map, options));
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(BeamLikelihood, CountsLengthsInCellSides) {  // 1 m of path: four sides of 0.25 m
  OccupancyMap map(0.25);
  for (int x = 0; x < 8; ++x) map.at({x, 0}) = known(0.2);
  EXPECT_NEAR(log_likelihood({{0.0, 0.1}, {1.0, 0.1}, /*hit=*/false}, map), 4 * std::log(0.8),
              1e-7);
}

TEST(BeamLikelihood, WeighedByLengthDoesNotDependOnTheDirection) {  // prod (1 - m_j)^x_j
  OccupancyMap map(0.5);
  for (int y = -25; y < 25; ++y) {
    for (int x = -25; x < 25; ++x) map.at({x, y}) = known(0.25);
  }
  Rng rng(3);
  for (int i = 0; i < 100; ++i) {
    const double angle = rng.uniform(-kPi, kPi);
    const Vector2d direction(std::cos(angle), std::sin(angle));
    const Vector2d start(rng.uniform(-1, 1), rng.uniform(-1, 1));
    const Beam beam{start, start + 10.0 * direction, /*hit=*/false};
    // 20 sides, less the part in the cell where the beam ends: up to its diagonal.
    const double sides = log_likelihood(beam, map) / std::log(0.75);
    EXPECT_GE(sides, 20.0 - std::sqrt(2.0) - 1e-6);
    EXPECT_LE(sides, 20.0 + 1e-6);
    // Once for each covered cell it would be |dx| + |dy| of them, up to 28 along a diagonal.
    const double cells = log_likelihood(beam, map, {.length_weighted = false}) / std::log(0.75);
    EXPECT_NEAR(cells, 20.0 * (std::abs(direction.x()) + std::abs(direction.y())), 2.0);
  }
}

TEST(BeamLikelihood, TakesUnknownCellsAsItIsTold) {
  const OccupancyMap map = row_of({0.0});
  const BeamLikelihoodOptions options{.unknown = 0.2, .least_m = 1e-12};
  EXPECT_NEAR(std::exp(log_likelihood(beam_into(2), map, options)), 1.0 * 0.8 * 0.2, 1e-9);
}

TEST(BeamLikelihood, NoBeamIsImpossible) {
  const OccupancyMap map = row_of({0.0, 1.0, 0.0});
  EXPECT_NEAR(std::exp(log_likelihood(beam_into(2), map, {.least_m = 0.01})), 0.99 * 0.01 * 0.01,
              1e-12);
}

TEST(BeamLikelihood, ByEndPointsIsTheFieldsAtEachHit) {
  struct Slope {  // ln p falls with x
    double log_at(const Vector2d& point) const { return -point.x(); }
  };
  LaserScan scan;
  scan.max_range = 2.0;
  scan.ranges = {1.25, 0.75, 2.0, 0.0};
  EXPECT_NEAR(end_point_log_likelihood(scan, Pose2{0.5, 0.0, 0.0}, Slope{}), -(1.75 + 1.25), 1e-12);
}

TEST(BeamLikelihood, OfAScanIsTheProductOverTheBeamsThatSaySomething) {
  const OccupancyMap map = row_of({0.1, 0.2, 0.3, 0.7});
  LaserScan scan;
  scan.max_range = 1.5;
  scan.ranges = {1.25, 0.75, 1.5, 0.0, -1.0};  // a step of 0 rad: all along the row
  const double expected = log_likelihood(beam_into(2), map) + log_likelihood(beam_into(1), map) +
                          log_likelihood(beam_through(3), map);
  EXPECT_NEAR(log_likelihood(scan, Pose2{0.0, 0.25, 0.0}, map), expected, 1e-12);
}

}  // namespace
}  // namespace mapbed
