#include "algorithms/field/likelihood_field.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/angle.h"
#include "core/random.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

const LikelihoodFieldOptions kOptions{.resolution = 0.05, .sigma = 0.06, .inlier_ratio = 0.85};

double plain_log(double distance) {
  return std::log(0.85 * std::exp(-distance * distance / (2 * 0.06 * 0.06)) + 0.15);
}

std::vector<Eigen::Vector2d> scattered_points(int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(rng.uniform(-4, 4), rng.uniform(-4, 4));
  return points;
}

TEST(LikelihoodField, IsTheMixtureOfTheDistanceToTheNearestPoint) {
  const std::vector<Eigen::Vector2d> points = scattered_points(300, 3);  // across tile borders too
  LikelihoodField field(kOptions);
  for (const Eigen::Vector2d& point : points) field.add(SurfacePoint{point});
  int compared = 0;
  for (const Eigen::Vector2d& p : scattered_points(20'000, 8)) {
    std::vector<double> distances;
    for (const Eigen::Vector2d& point : points) distances.push_back((point - p).norm());
    std::nth_element(distances.begin(), distances.begin() + 1, distances.end());
    const double nearest = *std::min_element(distances.begin(), distances.begin() + 2);
    // Where two points are about as near, the cell may know the other one: off by a cell's
    // diagonal.
    if (distances[1] - nearest < 0.05 * std::sqrt(2.0)) continue;
    ++compared;
    // At 3 sigma the mixture is within 0.06 of the floor, where the field ends.
    EXPECT_NEAR(field.log_at(p), nearest < 3 * 0.06 ? plain_log(nearest) : std::log(0.15),
                std::abs(nearest - 0.18) < 0.002 ? 0.07 : 1e-3);
  }
  EXPECT_GT(compared, 10'000);
}

TEST(LikelihoodField, MeasuresAgainstTheLineThroughAPoint) {
  LikelihoodField field(kOptions);
  const double angle = 0.4;  // of the line
  field.add(SurfacePoint{{1.0, 1.0}, {std::cos(2 * angle), std::sin(2 * angle)}});
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  const Eigen::Vector2d point(1.0, 1.0);
  EXPECT_NEAR(field.log_at(point + 0.07 * across), plain_log(0.07), 1e-3);
  EXPECT_NEAR(field.log_at(point + 0.07 * along), plain_log(0.007), 1e-3);
}

TEST(LikelihoodField, NoPointInACellScoresAboveTheCellsHighest) {
  LikelihoodField field(kOptions);
  for (const Eigen::Vector2d& point : scattered_points(100, 6)) field.add(SurfacePoint{point});
  for (const Eigen::Vector2d& point : scattered_points(100, 9)) {
    field.add(SurfacePoint{point, Eigen::Vector2d(point.x(), point.y()).normalized()});
  }
  constexpr int kSide = LikelihoodField::kTileSide;
  std::vector<std::uint8_t> bounds(kSide * kSide);
  int compared = 0;
  for (const CellIndex corner : field.tile_corners()) {
    field.bound_tile(corner, kSide, bounds.data());
    for (const Eigen::Vector2d& p : scattered_points(5'000, 7)) {
      const CellIndex cell = TiledGrid<char>(0.05).cell_of(p);
      const int x = cell.x - corner.x, y = cell.y - corner.y;
      if (x < 0 || y < 0 || x >= kSide || y >= kSide) continue;
      const double highest = field.bound_step() * bounds[static_cast<std::size_t>(y * kSide + x)];
      EXPECT_LE(field.log_at(p), double{field.outlier_log()} + highest + 1e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1'000);
}

TEST(LikelihoodField, IsTheFloorFarAwayAndAfterClearing) {
  LikelihoodField field(kOptions);
  EXPECT_FLOAT_EQ(static_cast<float>(field.log_at({0, 0})), field.outlier_log());
  field.add(SurfacePoint{{1.0, 1.0}});
  EXPECT_FLOAT_EQ(static_cast<float>(field.log_at({50.0, -70.0})), field.outlier_log());
  EXPECT_GT(field.log_at({1.0, 1.0}), -0.2);
  field.clear();
  EXPECT_FLOAT_EQ(static_cast<float>(field.log_at({1.0, 1.0})), field.outlier_log());
}

TEST(LikelihoodField, SumsWhatItSaysOfSinglePoints) {
  LikelihoodField field(kOptions);
  for (const Eigen::Vector2d& point : scattered_points(200, 4)) field.add(SurfacePoint{point});
  const std::vector<Eigen::Vector2d> points = scattered_points(50, 5);
  const Pose2 pose{0.3, -0.2, 0.7};
  double sum = 0.0;
  for (const Eigen::Vector2d& point : points) sum += field.log_at(pose * point);
  EXPECT_NEAR(field.sum_log_at(to_field_points(points, 0.05), pose), sum, 1e-2);
}

// Surfaces come and go, over several tiles, also where a whole tile becomes empty.
TEST(LikelihoodField, BroughtUpToDateIsTheFieldMadeAnew) {
  Rng rng(3);
  SurfaceMeans means(0.05);
  LikelihoodField updated;
  std::vector<std::vector<SurfacePoint>> scans;
  for (int step = 0; step < 12; ++step) {
    std::vector<SurfacePoint> scan(80);
    for (SurfacePoint& point : scan) {
      const double turn = rng.uniform(-kPi, kPi);
      point = {{0.4 * step + rng.uniform(-1.0, 1.0), rng.uniform(-2.5, 0.5)},
               {std::cos(turn), std::sin(turn)}};
    }
    scans.push_back(scan);
    means.add(scan);
    if (step >= 3) means.remove(scans[static_cast<std::size_t>(step) - 3]);
    updated.update(means, means.take_changed());
  }
  LikelihoodField anew;
  anew.add(means.means());
  int explained = 0;
  for (double y = -3.0; y < 1.0; y += 0.037) {
    for (double x = -1.5; x < 6.0; x += 0.037) {
      ASSERT_NEAR(updated.log_at({x, y}), anew.log_at({x, y}), 1e-5) << x << ", " << y;
      if (anew.log_at({x, y}) > anew.outlier_log()) ++explained;
    }
  }
  EXPECT_GT(explained, 1000);
  const CellBox box = updated.box(), expected = anew.box();
  EXPECT_EQ(box.min, expected.min);
  EXPECT_EQ(box.max, expected.max);
}

TEST(LikelihoodField, RefusesAReachThatTakesForeverAndPointsTooFarApart) {
  EXPECT_INPUT_ERROR(LikelihoodField({.resolution = 0.005, .sigma = 2.0}),
                     "sigma of 2 m is too large");
  LikelihoodField field;
  field.add(SurfacePoint{.position = {0.0, 0.0}});
  EXPECT_INPUT_ERROR(field.add(SurfacePoint{.position = {1e7, 1e7}}), "poses lie too far apart");
  EXPECT_GT(field.log_at({0.0, 0.0}), field.outlier_log()) << "what was there stays";
}

}  // namespace
}  // namespace mapbed
