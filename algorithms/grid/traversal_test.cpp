#include "algorithms/grid/traversal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

using Eigen::Vector2d;

std::vector<CoveredCell> cells_on(const Vector2d& start, const Vector2d& end,
                                  const GridFrame& frame) {
  std::vector<CoveredCell> cells;
  const CoveredCell last = traverse(start, end, frame, [&](CellIndex cell, double length) {
    cells.push_back({cell, length});
  });
  cells.push_back(last);
  return cells;
}

std::vector<std::pair<int, int>> indices_on(const Vector2d& start, const Vector2d& end) {
  std::vector<std::pair<int, int>> indices;
  for (const CoveredCell& covered : cells_on(start, end, GridFrame{.resolution = 1.0})) {
    indices.emplace_back(covered.cell.x, covered.cell.y);
  }
  return indices;
}

// The slow way: how much of the line lies inside one cell, by clipping it at the cell's four sides.
double clipped_length(const Vector2d& start, const Vector2d& end, CellIndex cell,
                      const GridFrame& frame) {
  const Vector2d low = frame.corner_of(cell);
  const Vector2d high = frame.corner_of({cell.x + 1, cell.y + 1});
  double first = 0.0, last = 1.0;  // fractions of the line
  for (int axis = 0; axis < 2; ++axis) {
    const double way = end[axis] - start[axis];
    if (way == 0.0) {
      if (start[axis] < low[axis] || start[axis] >= high[axis]) return 0.0;
      continue;
    }
    const double a = (low[axis] - start[axis]) / way;
    const double b = (high[axis] - start[axis]) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return std::max(0.0, last - first) * (end - start).norm();
}

void expect_as_clipped(const Vector2d& start, const Vector2d& end, const GridFrame& frame) {
  const std::vector<CoveredCell> cells = cells_on(start, end, frame);
  double total = 0.0;
  for (const CoveredCell& covered : cells) {
    EXPECT_GE(covered.length, 0.0);
    EXPECT_NEAR(covered.length, clipped_length(start, end, covered.cell, frame), 1e-9);
    total += covered.length;
  }
  // Nothing is missing: the covered cells make up the whole line.
  EXPECT_NEAR(total, (end - start).norm(), 1e-9);
  EXPECT_EQ(cells.back().cell, frame.cell_of(end));
}

TEST(Traversal, AgreesWithClippingTheLineAtEachCell) {
  Rng rng(7);
  for (int i = 0; i < 2000; ++i) {
    const GridFrame frame{.resolution = rng.uniform(0.02, 0.5),
                          .origin = {rng.uniform(-1, 1), rng.uniform(-1, 1)}};
    const Vector2d start(rng.uniform(-4, 4), rng.uniform(-4, 4));
    const Vector2d end(rng.uniform(-4, 4), rng.uniform(-4, 4));
    expect_as_clipped(start, end, frame);
  }
}

TEST(Traversal, AgreesWithClippingFromCornersBordersAndCenters) {
  // Every line between half-cell places: along borders, through corners, axis-parallel, of length
  // 0.
  const GridFrame frame{.resolution = 0.5};
  for (int from = 0; from < 25; ++from) {
    for (int to = 0; to < 25; ++to) {
      const Vector2d start(0.25 * (from % 5) - 0.5, 0.25 * (from / 5) - 0.5);
      const Vector2d end(0.25 * (to % 5) - 0.5, 0.25 * (to / 5) - 0.5);
      expect_as_clipped(start, end, frame);
    }
  }
}

TEST(Traversal, AgreesWithClippingAfterEightyMetres) {
  const GridFrame frame{.resolution = 0.05};
  for (const double angle : {0.0, 1e-9, 0.3, M_PI / 4, 1.2, M_PI / 2, 3.0, M_PI, -0.4, -2.5}) {
    const Vector2d start(-40.03, 25.01);
    expect_as_clipped(start, start + 80.0 * Vector2d(std::cos(angle), std::sin(angle)), frame);
  }
}

TEST(Traversal, VisitsCellsInOrder) {
  EXPECT_THAT(
      indices_on({0.5, 0.5}, {3.5, 0.5}),
      ::testing::ElementsAre(std::pair(0, 0), std::pair(1, 0), std::pair(2, 0), std::pair(3, 0)));
  EXPECT_THAT(indices_on({0.5, 0.5}, {-1.5, 1.5}),
              ::testing::ElementsAre(std::pair(0, 0), std::pair(-1, 0), std::pair(-1, 1),
                                     std::pair(-2, 1)));
}

TEST(Traversal, LeavesOutCellsTouchedInACornerOnly) {
  EXPECT_THAT(indices_on({0.5, 0.5}, {2.5, 2.5}),
              ::testing::ElementsAre(std::pair(0, 0), std::pair(1, 1), std::pair(2, 2)));
  EXPECT_THAT(indices_on({0.5, 2.5}, {2.5, 0.5}),
              ::testing::ElementsAre(std::pair(0, 2), std::pair(1, 1), std::pair(2, 0)));
}

TEST(Traversal, StepsOverABorderByTheSmallestNumber) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_THAT(indices_on({0.0, 0.5}, {-tiny, 0.5}), ::testing::ElementsAre(std::pair(-1, 0)));
  EXPECT_THAT(indices_on({-tiny, -tiny}, {0.0, 0.0}),
              ::testing::ElementsAre(std::pair(-1, -1), std::pair(0, 0)));
  expect_as_clipped({0.0, 0.0}, {-tiny, 2.5}, GridFrame{.resolution = 1.0});
}

TEST(Traversal, OfAPointIsItsCell) {
  EXPECT_THAT(indices_on({1.25, -0.5}, {1.25, -0.5}), ::testing::ElementsAre(std::pair(1, -1)));
}

}  // namespace
}  // namespace mapbed
