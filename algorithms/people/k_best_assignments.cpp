#include "algorithms/people/k_best_assignments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "core/assignment.h"

namespace mapbed {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

// All assignments that the cost matrix still allows, by the cheapest of them.
struct Subset {
  RankedAssignment best;
  Eigen::MatrixXd cost;
  Eigen::Index fixed = 0;  // rows from the first on that have their column
};

struct IsDearer {
  bool operator()(const Subset& a, const Subset& b) const { return a.best.cost > b.best.cost; }
};

std::optional<Subset> subset_of(Eigen::MatrixXd cost, Eigen::Index fixed) {
  std::vector<int> columns = cheapest_assignment(cost);
  if (std::find(columns.begin(), columns.end(), -1) != columns.end()) return {};
  const double least = cost_of(columns, cost);
  if (!std::isfinite(least)) return {};
  return Subset{{std::move(columns), least}, std::move(cost), fixed};
}

void fix(Eigen::MatrixXd& cost, Eigen::Index row, Eigen::Index column) {
  const double kept = cost(row, column);
  cost.row(row).setConstant(kForbidden);
  cost.col(column).setConstant(kForbidden);
  cost(row, column) = kept;
}

}  // namespace

std::vector<RankedAssignment> k_best_assignments(const Eigen::MatrixXd& cost, int count) {
  std::vector<RankedAssignment> ranked;
  std::priority_queue<Subset, std::vector<Subset>, IsDearer> subsets;
  if (auto all = subset_of(cost, 0)) subsets.push(std::move(*all));
  while (!subsets.empty() && static_cast<int>(ranked.size()) < count) {
    const Subset cheapest = subsets.top();
    subsets.pop();
    ranked.push_back(cheapest.best);
    // What is left of the subset, cut so that each assignment is in one part: those that have the
    // columns of this one in the rows before, and another one in this row.
    Eigen::MatrixXd left = cheapest.cost;
    for (Eigen::Index row = cheapest.fixed; row < left.rows(); ++row) {
      const Eigen::Index column = cheapest.best.columns[static_cast<std::size_t>(row)];
      Eigen::MatrixXd part = left;
      part(row, column) = kForbidden;
      if (auto subset = subset_of(std::move(part), row)) subsets.push(std::move(*subset));
      fix(left, row, column);
    }
  }
  return ranked;
}

}  // namespace mapbed
