#pragma once

#include <vector>

#include <Eigen/Core>

namespace mapbed {

struct RankedAssignment {
  std::vector<int> columns;  // of each row
  double cost = 0.0;
};

// The `count` cheapest ways to give each row a column of its own, cheapest first (Murty, "An
// algorithm for ranking all the assignments in order of increasing cost", 1968). An infinite cost
// forbids a pair; fewer where there are no more.
std::vector<RankedAssignment> k_best_assignments(const Eigen::MatrixXd& cost, int count);

}  // namespace mapbed
