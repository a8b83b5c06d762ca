#include "algorithms/pose_graph/sparse_factor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "algorithms/pose_graph/factor_pattern.h"
#include "core/check.h"

namespace mapbed {
namespace {

template <int B>
std::vector<std::pair<int, int>> pairs_of(std::span<const NodeBlock<B>> blocks) {
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(blocks.size());
  for (const NodeBlock<B>& block : blocks) pairs.emplace_back(block.row, block.col);
  return pairs;
}

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

template <int B>
SparseFactor<B>::SparseFactor(int nodes, std::span<const NodeBlock<B>> blocks) {
  FactorPattern pattern = factor_pattern(nodes, pairs_of<B>(blocks));
  nodes_ = std::move(pattern.nodes);
  places_ = std::move(pattern.places);
  columns_.reserve(at(nodes));
  for (const std::vector<int>& rows : pattern.below) {
    columns_.push_back({rows_.size(), static_cast<int>(rows.size())});
    rows_.insert(rows_.end(), rows.begin(), rows.end());
  }
  diagonal_.resize(at(nodes));
  reduced_.resize(at(nodes));
}

template <int B>
Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, B>> SparseFactor<B>::panel(int place) {
  const Column& column = columns_[at(place)];
  return {panels_.data() + column.begin * B * B, column.size * B, B};
}

template <int B>
Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, B>> SparseFactor<B>::panel(int place) const {
  const Column& column = columns_[at(place)];
  return {panels_.data() + column.begin * B * B, column.size * B, B};
}

template <int B>
std::span<const int> SparseFactor<B>::rows_below(int place) const {
  const Column& column = columns_[at(place)];
  return {rows_.data() + column.begin, at(column.size)};
}

template <int B>
int SparseFactor<B>::index_of(int row, int column) const {
  const std::span<const int> rows = rows_below(column);
  const auto found = std::lower_bound(rows.begin(), rows.end(), row);
  CHECK(found != rows.end() && *found == row);
  return static_cast<int>(found - rows.begin());
}

// H, in the place of L.
template <int B>
void SparseFactor<B>::gather(std::span<const NodeBlock<B>> blocks) {
  std::fill(diagonal_.begin(), diagonal_.end(), Block::Zero());
  panels_.assign(rows_.size() * B * B, 0.0);
  for (const NodeBlock<B>& block : blocks) {
    const int row = places_[at(block.row)];
    const int col = places_[at(block.col)];
    if (row == col) {
      diagonal_[at(row)] += block.value;
    } else if (row > col) {
      panel(col).template middleRows<B>(B * index_of(row, col)) += block.value;
    } else {
      panel(row).template middleRows<B>(B * index_of(col, row)) += block.value.transpose();
    }
  }
}

// What a column that is done takes from those to come.
template <int B>
void SparseFactor<B>::subtract_from_later(int place) {
  const auto done = panel(place);
  const std::span<const int> rows = rows_below(place);
  Eigen::Matrix<double, Eigen::Dynamic, B> product(done.rows(), B);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int later = rows[r];
    const Block factor = done.template middleRows<B>(static_cast<int>(r) * B).transpose();
    diagonal_[at(later)] -= done.template middleRows<B>(static_cast<int>(r) * B) * factor;
    const auto left = static_cast<int>(rows.size() - r - 1);
    if (left == 0) continue;
    if (columns_[at(later)].size == left) {  // the same rows
      panel(later).noalias() -= done.bottomRows(left * B).lazyProduct(factor);
      continue;
    }
    product.topRows(left * B).noalias() = done.bottomRows(left * B).lazyProduct(factor);
    auto target = panel(later);
    const std::span<const int> targets = rows_below(later);
    std::size_t t = 0;
    for (int i = 0; i < left; ++i) {
      while (targets[t] != rows[r + 1 + at(i)]) ++t;
      target.template middleRows<B>(static_cast<int>(t) * B) -=
          product.template middleRows<B>(i * B);
    }
  }
}

template <int B>
bool SparseFactor<B>::factorize(std::span<const NodeBlock<B>> blocks, const Eigen::VectorXd& h,
                                double c) {
  CHECK(h.size() == 0 || h.size() == nodes() * B);
  pack();
  gather(blocks);
  for (std::size_t p = 0; p < nodes_.size(); ++p) {
    reduced_[p].setZero();
    if (h.size() > 0) reduced_[p] = h.template segment<B>(nodes_[p] * B);
  }
  minimum_ = c;
  rounding_ = 1.0;
  factored_ = false;
  for (int p = 0; p < nodes(); ++p) {
    const Eigen::LLT<Block> cholesky(diagonal_[at(p)]);
    if (cholesky.info() != Eigen::Success || !diagonal_[at(p)].allFinite()) return false;
    diagonal_[at(p)] = cholesky.matrixL();
    if (columns_[at(p)].size > 0) {
      cholesky.matrixU().template solveInPlace<Eigen::OnTheRight>(panel(p));
    }
    cholesky.matrixL().solveInPlace(reduced_[at(p)]);
    minimum_ -= reduced_[at(p)].squaredNorm();
    subtract_from_later(p);
    const auto done = panel(p);
    const std::span<const int> rows = rows_below(p);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      reduced_[at(rows[r])] -=
          done.template middleRows<B>(static_cast<int>(r) * B) * reduced_[at(p)];
    }
  }
  factored_ = true;
  return true;
}

template <int B>
Eigen::VectorXd SparseFactor<B>::solve(const Eigen::VectorXd& right_side) const {
  CHECK(factored_ && right_side.size() == nodes() * B);
  std::vector<Vector> y(nodes_.size());
  for (std::size_t p = 0; p < nodes_.size(); ++p) {
    y[p] = right_side.template segment<B>(nodes_[p] * B);
  }
  for (int p = 0; p < nodes(); ++p) {
    diagonal_[at(p)].template triangularView<Eigen::Lower>().solveInPlace(y[at(p)]);
    const auto column = panel(p);
    const std::span<const int> rows = rows_below(p);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      y[at(rows[r])] -= column.template middleRows<B>(static_cast<int>(r) * B) * y[at(p)];
    }
  }
  return solve_upper(std::move(y));
}

template <int B>
Eigen::VectorXd SparseFactor<B>::minimizer() const {
  CHECK(factored_);
  return solve_upper(reduced_);
}

// L' x = y
template <int B>
Eigen::VectorXd SparseFactor<B>::solve_upper(std::vector<Vector> y) const {
  Eigen::VectorXd x(nodes() * B);
  for (int p = nodes() - 1; p >= 0; --p) {
    Vector& value = y[at(p)];
    const auto column = panel(p);
    const std::span<const int> rows = rows_below(p);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      value -= column.template middleRows<B>(static_cast<int>(r) * B).transpose() * y[at(rows[r])];
    }
    diagonal_[at(p)].template triangularView<Eigen::Lower>().transpose().solveInPlace(value);
    x.template segment<B>(nodes_[at(p)] * B) = value;
  }
  return x;
}

template <int B>
double SparseFactor<B>::log_determinant() const {
  CHECK(factored_);
  double sum = 0.0;
  for (const Block& block : diagonal_) sum += 2.0 * block.diagonal().array().log().sum();
  return sum;
}

template <int B>
std::size_t SparseFactor<B>::blocks() const {
  return nodes_.size() + rows_.size() - unused_;
}

// Without what was left when columns grew, in the order of the columns.
template <int B>
void SparseFactor<B>::pack() {
  if (unused_ == 0) return;
  std::vector<int> rows;
  std::vector<double> panels;
  rows.reserve(rows_.size() - unused_);
  panels.reserve((rows_.size() - unused_) * B * B);
  for (Column& column : columns_) {
    const auto first = static_cast<std::ptrdiff_t>(column.begin);
    column.begin = rows.size();
    rows.insert(rows.end(), rows_.begin() + first, rows_.begin() + first + column.size);
    panels.insert(panels.end(), panels_.begin() + first * B * B,
                  panels_.begin() + (first + column.size) * B * B);
  }
  rows_ = std::move(rows);
  panels_ = std::move(panels);
  unused_ = 0;
}

template class SparseFactor<3>;
template class SparseFactor<4>;
template class SparseFactor<6>;

}  // namespace mapbed
