#include "core/assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kInf = std::numeric_limits<double>::infinity();

Eigen::MatrixXd matrix(int rows, int columns, const std::vector<double>& values) {
  Eigen::MatrixXd m(rows, columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) m(i, j) = values[static_cast<std::size_t>(i * columns + j)];
  }
  return m;
}

TEST(Assignment, TheNearestPairIsNotAlwaysMade) {
  EXPECT_THAT(cheapest_assignment(matrix(2, 2, {1, 2, 2, 9})), ElementsAre(1, 0));
}

TEST(Assignment, ARowIsLeftOutWhereThereAreTooFewColumns) {
  EXPECT_THAT(cheapest_assignment(matrix(3, 1, {3, 1, 2})), ElementsAre(-1, 0, -1));
  EXPECT_THAT(cheapest_assignment(matrix(1, 3, {3, 1, 2})), ElementsAre(1));
}

TEST(Assignment, AForbiddenPairIsNotMade) {
  EXPECT_THAT(cheapest_assignment(matrix(2, 2, {1, kInf, kInf, kInf})), ElementsAre(0, -1));
}

TEST(Assignment, AsManyPairsAsPossibleComeBeforeTheirCost) {
  EXPECT_THAT(cheapest_assignment(matrix(2, 2, {1, 100, kInf, kInf})).front(), 0);
  EXPECT_THAT(cheapest_assignment(matrix(2, 2, {1, 100, 2, kInf})), ElementsAre(1, 0));
}

TEST(Assignment, OfNothingIsEmpty) {
  EXPECT_THAT(cheapest_assignment(Eigen::MatrixXd(0, 3)), IsEmpty());
  EXPECT_THAT(cheapest_assignment(Eigen::MatrixXd(2, 0)), ElementsAre(-1, -1));
}

// By trying every way to give columns to rows; -1 is many of the same column.
double least_by_trying(const Eigen::MatrixXd& cost, std::size_t& pairs) {
  const auto rows = static_cast<std::size_t>(cost.rows());
  const auto columns = static_cast<std::size_t>(cost.cols());
  std::vector<std::size_t> order(std::max(rows, columns));
  std::iota(order.begin(), order.end(), 0U);
  double least = kInf;
  pairs = 0;
  do {
    double sum = 0.0;
    std::size_t made = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      if (order[row] >= columns) continue;
      const double c = cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(order[row]));
      if (std::isinf(c)) continue;
      sum += c;
      ++made;
    }
    if (made > pairs || (made == pairs && sum < least)) {
      pairs = made;
      least = sum;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(Assignment, IsTheCheapestOfAllThatThereAre) {
  Rng rng(1);
  for (int i = 0; i < 300; ++i) {
    const int rows = 1 + static_cast<int>(rng.index(5)),
              columns = 1 + static_cast<int>(rng.index(5));
    Eigen::MatrixXd cost(rows, columns);
    for (double& c : cost.reshaped()) c = rng.uniform() < 0.2 ? kInf : rng.uniform(-5.0, 5.0);
    std::size_t pairs = 0;
    const double least = least_by_trying(cost, pairs);
    const std::vector<int> found = cheapest_assignment(cost);
    EXPECT_EQ(static_cast<std::size_t>(
                  std::count_if(found.begin(), found.end(), [](int c) { return c >= 0; })),
              pairs);
    EXPECT_NEAR(cost_of(found, cost), pairs == 0 ? 0.0 : least, 1e-9) << cost;
  }
}

}  // namespace
}  // namespace mapbed
