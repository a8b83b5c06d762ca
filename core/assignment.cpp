#include "core/assignment.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "core/check.h"

namespace mapbed {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// So dear that one pair less always costs more than any choice among the others.
Eigen::MatrixXd with_finite_costs(const Eigen::MatrixXd& cost) {
  double most = 0.0;
  for (const double c : cost.reshaped()) {
    CHECK(!std::isnan(c) && c != -kInfinite);
    if (std::isfinite(c)) most = std::max(most, std::abs(c));
  }
  const double forbidden =
      (2.0 * most + 1.0) * static_cast<double>(std::min(cost.rows(), cost.cols()) + 1);
  return cost.unaryExpr([&](double c) { return std::isfinite(c) ? c : forbidden; });
}

// Rows are added one by one, each along the cheapest alternating path to a free column. The last
// column of the arrays stands for none, from which each search begins.
class ShortestPaths {
 public:
  explicit ShortestPaths(const Eigen::MatrixXd& cost)
      : cost_(cost),
        columns_(static_cast<std::size_t>(cost.cols())),
        row_price_(static_cast<std::size_t>(cost.rows()), 0.0),
        column_price_(columns_ + 1, 0.0),
        row_of_(columns_ + 1, -1) {}

  void add(int row) {
    std::vector<double> distance(columns_ + 1, kInfinite);
    std::vector<bool> is_done(columns_ + 1, false);
    std::vector<std::size_t> before(columns_ + 1, columns_);
    std::size_t column = columns_;
    row_of_[column] = row;
    while (row_of_[column] >= 0) {
      is_done[column] = true;
      column = next_column(column, distance, is_done, before);
    }
    for (; column != columns_; column = before[column]) row_of_[column] = row_of_[before[column]];
  }

  std::vector<int> columns_of_rows() const {
    std::vector<int> result(row_price_.size(), -1);
    for (std::size_t column = 0; column < columns_; ++column) {
      if (row_of_[column] >= 0) {
        result[static_cast<std::size_t>(row_of_[column])] = static_cast<int>(column);
      }
    }
    return result;
  }

 private:
  // The nearest column that is not done, with the prices moved to where it is reached.
  std::size_t next_column(std::size_t from, std::vector<double>& distance,
                          const std::vector<bool>& is_done, std::vector<std::size_t>& before) {
    const int row = row_of_[from];
    double least = kInfinite;
    std::size_t nearest = columns_;
    for (std::size_t column = 0; column < columns_; ++column) {
      if (is_done[column]) continue;
      const double reduced = cost_(row, static_cast<Eigen::Index>(column)) -
                             row_price_[static_cast<std::size_t>(row)] - column_price_[column];
      if (reduced < distance[column]) {
        distance[column] = reduced;
        before[column] = from;
      }
      if (distance[column] < least) {
        least = distance[column];
        nearest = column;
      }
    }
    for (std::size_t column = 0; column <= columns_; ++column) {
      if (is_done[column]) {
        row_price_[static_cast<std::size_t>(row_of_[column])] += least;
        column_price_[column] -= least;
      } else {
        distance[column] -= least;
      }
    }
    return nearest;
  }

  const Eigen::MatrixXd& cost_;
  std::size_t columns_;
  std::vector<double> row_price_;
  std::vector<double> column_price_;
  std::vector<int> row_of_;  // by column; -1: free
};

std::vector<int> assigned_rows(const Eigen::MatrixXd& cost) {
  ShortestPaths paths(cost);
  for (int row = 0; row < static_cast<int>(cost.rows()); ++row) paths.add(row);
  return paths.columns_of_rows();
}

}  // namespace

std::vector<int> cheapest_assignment(const Eigen::MatrixXd& cost) {
  std::vector<int> result(static_cast<std::size_t>(cost.rows()), -1);
  if (cost.size() == 0) return result;
  const Eigen::MatrixXd finite = with_finite_costs(cost);
  if (cost.rows() <= cost.cols()) {
    result = assigned_rows(finite);
  } else {
    const std::vector<int> row_of = assigned_rows(finite.transpose());
    for (std::size_t column = 0; column < row_of.size(); ++column) {
      if (row_of[column] >= 0)
        result[static_cast<std::size_t>(row_of[column])] = static_cast<int>(column);
    }
  }
  for (std::size_t row = 0; row < result.size(); ++row) {
    if (result[row] >= 0 && !std::isfinite(cost(static_cast<Eigen::Index>(row), result[row]))) {
      result[row] = -1;
    }
  }
  return result;
}

double cost_of(const std::vector<int>& assignment, const Eigen::MatrixXd& cost) {
  double sum = 0.0;
  for (std::size_t row = 0; row < assignment.size(); ++row) {
    if (assignment[row] >= 0) sum += cost(static_cast<Eigen::Index>(row), assignment[row]);
  }
  return sum;
}

}  // namespace mapbed
