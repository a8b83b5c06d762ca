#pragma once

#include <vector>

#include <Eigen/Core>

namespace mapbed {

// The rectangular assignment problem, by shortest augmenting paths (Crouse, "On implementing 2D
// rectangular assignment algorithms", 2016): each row gets at most one column and each column goes
// to at most one row, of all ways to make as many pairs as possible the one of least total cost.
// An infinite cost forbids a pair. result[row] is the column, or -1. O(rows^2 columns).
std::vector<int> cheapest_assignment(const Eigen::MatrixXd& cost);

// Its total cost; 0 where there are no pairs.
double cost_of(const std::vector<int>& assignment, const Eigen::MatrixXd& cost);

}  // namespace mapbed
