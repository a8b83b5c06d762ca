#include "bench/metrics/doubled_walls.h"

#include <cmath>

#include <gmock/gmock.h>

namespace mapbed {
namespace {

constexpr int kSide = 40;  // [cells] of 10 cm, 4 m

CellIndex cell_of(const TrueMap& truth, const Eigen::Vector2d& point) {
  const Eigen::Array2d cell = (point / truth.resolution).array().floor();
  return {static_cast<int>(cell.x()), static_cast<int>(cell.y())};
}

// Open ground with a wall at y = 2 m that rises by `slope`, and the map that a perfect robot makes.
class DoubledWallsOf : public ::testing::TestWithParam<double> {
 protected:
  DoubledWallsOf() {
    truth_ = {.resolution = 0.1, .width = kSide, .height = kSide};
    truth_.cells.assign(std::size_t{kSide} * kSide, TrueCell::free);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) map_.at({x, y}) = known(0.1);
    }
    add_true_wall(2.0);
    draw_wall(2.0);
  }
  // At this height above the middle, in all columns from `first` on.
  template <class Visitor>
  void for_each_cell(double height, Visitor&& visit, int first = 0) const {
    for (double x = 0.1 * first + 0.01; x < 0.1 * kSide; x += 0.02) {
      visit(cell_of(truth_, {x, height + GetParam() * (x - 2.0)}));
    }
  }
  void add_true_wall(double height) {
    for_each_cell(height,
                  [&](CellIndex c) { truth_.cells[truth_.index(c.x, c.y)] = TrueCell::occupied; });
  }
  void draw_wall(double height, int first = 0) {
    for_each_cell(
        height, [&](CellIndex c) { map_.at(c) = known(0.9); }, first);
  }
  double fraction() const { return doubled_walls(map_, truth_).fraction(); }

  TrueMap truth_;
  OccupancyMap map_{0.1};
};

TEST_P(DoubledWallsOf, APerfectMapAreNone) {
  const DoubledWalls result = doubled_walls(map_, truth_);
  EXPECT_EQ(result.doubled, 0);
  EXPECT_GE(result.walls, kSide - 2);  // all but, where the wall is steep, its ends
}

TEST_P(DoubledWallsOf, AMapWithASecondWallNearbyAreAll) {
  draw_wall(2.5);
  EXPECT_GE(fraction(), 1.0 - 2.0 / kSide);  // the normal at a steep wall's end goes past the other
}

TEST_P(DoubledWallsOf, AMapWithASecondWallInOneHalfAreHalf) {
  draw_wall(2.5, kSide / 2);
  // The strip sees a cell and a half to the sides, and the normal of a steep wall leans by 0.3 m.
  EXPECT_NEAR(fraction(), 0.5, 6.0 / kSide);
}

TEST_P(DoubledWallsOf, ASecondWallFurtherThanTheReachIsNone) {
  draw_wall(3.5);  // across the steepest wall 1.29 m
  EXPECT_DOUBLE_EQ(fraction(), 0.0);
}

TEST_P(DoubledWallsOf, AThickWallIsOne) {
  draw_wall(2.1);
  draw_wall(2.2);
  EXPECT_DOUBLE_EQ(fraction(), 0.0);
}

TEST_P(DoubledWallsOf, WallsThatThereAreTwiceAreNone) {
  add_true_wall(2.5);
  draw_wall(2.5);
  EXPECT_DOUBLE_EQ(fraction(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Slopes, DoubledWallsOf, ::testing::Values(0.0, 0.2, -0.6));

// The far face of a wall that the robot saw from one side only does not excuse a second one.
TEST(DoubledWalls, FacesThatTheRobotNeverSawDoNotCount) {
  TrueMap truth{.resolution = 0.1, .width = kSide, .height = kSide};
  truth.cells.assign(std::size_t{kSide} * kSide, TrueCell::free);
  OccupancyMap map(0.1);
  for (int x = 0; x < kSide; ++x) {
    truth.cells[truth.index(x, 20)] = TrueCell::occupied;  // the faces of a wall of 50 cm
    truth.cells[truth.index(x, 24)] = TrueCell::occupied;
    for (int y = 10; y <= 20; ++y) map.at({x, y}) = known(y == 20 ? 0.9 : 0.1);
  }
  EXPECT_DOUBLE_EQ(doubled_walls(map, truth).fraction(), 0.0);
  for (int x = 0; x < kSide; ++x) map.at({x, 15}) = known(0.9);
  EXPECT_DOUBLE_EQ(doubled_walls(map, truth).fraction(), 1.0);
}

TEST(DoubledWalls, AreNotLookedForAtCornersAndPosts) {
  TrueMap truth{.resolution = 0.1, .width = kSide, .height = kSide};
  truth.cells.assign(std::size_t{kSide} * kSide, TrueCell::free);
  OccupancyMap map(0.1);
  for (int i = 10; i < 30; ++i) {
    truth.cells[truth.index(i, 10)] = TrueCell::occupied;
    truth.cells[truth.index(10, i)] = TrueCell::occupied;
  }
  truth.cells[truth.index(25, 25)] = TrueCell::occupied;
  map.at({10, 10}) = map.at({25, 25}) = known(0.9);
  const DoubledWalls none = doubled_walls(map, truth);
  EXPECT_EQ(none.walls, 0);
  EXPECT_TRUE(std::isnan(none.fraction()));
  map.at({20, 10}) = known(0.9);
  EXPECT_EQ(doubled_walls(map, truth).walls, 3);  // the cell, and those beside it
}

// A wall upright in the picture at column 20, and a second one 1 m beside it: the reach, so the
// strip's very last look, half a cell on, is the one that meets it.
TEST(DoubledWalls, AreSeenAtTheReachToEitherSideAndNotBeyond) {
  const auto fraction_with_wall_at = [](int second) {
    TrueMap truth{.resolution = 0.1, .width = kSide, .height = kSide};
    truth.cells.assign(std::size_t{kSide} * kSide, TrueCell::free);
    OccupancyMap map(0.1);
    for (int y = 0; y < kSide; ++y) {
      truth.cells[truth.index(20, y)] = TrueCell::occupied;
      for (int x = 0; x < kSide; ++x) map.at({x, y}) = known(x == 20 || x == second ? 0.9 : 0.1);
    }
    return doubled_walls(map, truth, {.reach = 1.0}).fraction();
  };
  EXPECT_DOUBLE_EQ(fraction_with_wall_at(10), 1.0);
  EXPECT_DOUBLE_EQ(fraction_with_wall_at(30), 1.0);
  EXPECT_DOUBLE_EQ(fraction_with_wall_at(9), 0.0);
  EXPECT_DOUBLE_EQ(fraction_with_wall_at(31), 0.0);
}

}  // namespace
}  // namespace mapbed
