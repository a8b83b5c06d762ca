#include "algorithms/field/bound_sums.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

class BoundSums : public ::testing::Test {
 protected:
  BoundSums() {
    for (int i = 0; i < 200; ++i) {
      field_.add(SurfacePoint{{rng_.uniform(-2, 2), rng_.uniform(-2, 2)}});
    }
    pyramid_ = make_bound_pyramid(field_, 6.4);
  }

  PointsInCells scattered(int reach) {
    PointsInCells points;
    for (int i = 0; i < 50; ++i) {
      points.x.push_back(static_cast<int>(rng_.uniform(-reach, reach)));
      points.y.push_back(static_cast<int>(rng_.uniform(-reach, reach)));
    }
    return points;
  }

  // One point after the other, as each level tells.
  int plain_sum(const PointsInCells& points, int level, int x, int y) const {
    int sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t its =
          points.level.empty() ? static_cast<std::size_t>(level) : points.level[i];
      sum += its == PointsInCells::kUnbounded
                 ? 255
                 : pyramid_.levels[its].at(points.x[i] + x, points.y[i] + y);
    }
    return sum;
  }

  void expect_plain_sums(const PointsInCells& points, const BlockGrid& grid) const {
    std::vector<int> sums;
    sum_bounds(pyramid_, points, grid, sums);
    ASSERT_EQ(sums.size(), static_cast<std::size_t>(grid.rows * grid.columns));
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        EXPECT_EQ(sums[static_cast<std::size_t>(row * grid.columns + column)],
                  plain_sum(points, grid.level, grid.x + (column << grid.level),
                            grid.y + (row << grid.level)))
            << "level " << grid.level << ", row " << row << ", column " << column;
      }
    }
  }

  Rng rng_{3};
  LikelihoodField field_;
  BoundPyramid pyramid_;
};

// Near the map and, as blocks of high levels reach far, outside of it to all sides.
TEST_F(BoundSums, AreThoseOfEachBlockByItself) {
  for (int level = 0; level < static_cast<int>(pyramid_.levels.size()); ++level) {
    for (const auto& [columns, rows] : {std::pair(1, 2), {2, 2}, {4, 4}, {7, 5}}) {
      expect_plain_sums(scattered(60), {-11, -7, level, columns, rows});
    }
  }
}

TEST_F(BoundSums, TakeEachPointInItsLevel) {
  for (int level = 0; level < static_cast<int>(pyramid_.levels.size()); ++level) {
    PointsInCells points = scattered(60);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t its = static_cast<std::size_t>(level) + i % 4;
      points.level.push_back(its < pyramid_.levels.size() ? static_cast<std::uint8_t>(its)
                                                          : PointsInCells::kUnbounded);
    }
    expect_plain_sums(points, {-13, 5, level, 5, 3});
    const PointsInCells mixed = points;
    sort_by_level(points);
    EXPECT_TRUE(std::is_sorted(points.level.begin(), points.level.end()));
    expect_plain_sums(points, {-13, 5, level, 5, 3});
    EXPECT_EQ(plain_sum(points, level, 3, 4), plain_sum(mixed, level, 3, 4));
  }
}

// More of them than two bytes have room for the sum of, all at the largest bound.
TEST_F(BoundSums, HoldForMoreThanTwoBytesCount) {
  PointsInCells points;
  const LikelihoodField::Surface on = *field_.surface_at({0.0, 0.0});
  const CellIndex cell{static_cast<int>(std::floor(on.point.x() / field_.resolution())),
                       static_cast<int>(std::floor(on.point.y() / field_.resolution()))};
  points.x.assign(1000, cell.x);
  points.y.assign(1000, cell.y);
  for (int level = 0; level < static_cast<int>(pyramid_.levels.size()); ++level) {
    ASSERT_GT(plain_sum(points, level, 0, 0), UINT16_MAX) << level;
    expect_plain_sums(points, {0, 0, level, 2, 2});
  }
}

}  // namespace
}  // namespace mapbed
