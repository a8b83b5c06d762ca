#include "algorithms/people/k_best_assignments.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace mapbed {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

void enumerate(const Eigen::MatrixXd& cost, std::vector<int>& columns, double sum,
               std::vector<double>& costs) {
  const auto row = static_cast<Eigen::Index>(columns.size());
  if (row == cost.rows()) return costs.push_back(sum);
  for (int j = 0; j < cost.cols(); ++j) {
    const bool is_taken = std::find(columns.begin(), columns.end(), j) != columns.end();
    if (is_taken || cost(row, j) == kForbidden) continue;
    columns.push_back(j);
    enumerate(cost, columns, sum + cost(row, j), costs);
    columns.pop_back();
  }
}

std::vector<double> all_costs(const Eigen::MatrixXd& cost) {
  std::vector<double> costs;
  std::vector<int> columns;
  enumerate(cost, columns, 0.0, costs);
  std::sort(costs.begin(), costs.end());
  return costs;
}

TEST(KBestAssignments, AreTheCheapestOfAllInOrder) {
  Rng rng(3);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::MatrixXd cost(3, 5);
    for (double& c : cost.reshaped()) c = rng.uniform() < 0.2 ? kForbidden : rng.uniform();
    const std::vector<double> expected = all_costs(cost);
    const std::vector<RankedAssignment> ranked = k_best_assignments(cost, 12);
    ASSERT_EQ(ranked.size(), std::min<std::size_t>(12, expected.size()));
    for (std::size_t k = 0; k < ranked.size(); ++k) {
      EXPECT_NEAR(ranked[k].cost, expected[k], 1e-12) << "of trial " << trial;
    }
  }
}

TEST(KBestAssignments, EachStandsThereOnceUntilThereAreNoMore) {
  const Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(3, 3, 1.0);
  std::set<std::vector<int>> columns;
  for (const RankedAssignment& a : k_best_assignments(cost, 100)) columns.insert(a.columns);
  EXPECT_EQ(columns.size(), 6U);  // 3!
}

TEST(KBestAssignments, OfWhatIsForbiddenAreNone) {
  EXPECT_TRUE(k_best_assignments(Eigen::MatrixXd::Constant(2, 2, kForbidden), 3).empty());
}

}  // namespace
}  // namespace mapbed
