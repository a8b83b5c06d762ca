#include "algorithms/pose_graph/fronts/block_cholesky.h"

#include <algorithm>

#include "algorithms/pose_graph/fronts/dense_front.h"

namespace mapbed {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

std::size_t square(std::size_t i) {
  return i * i;
}

}  // namespace

template <int kSize>
BlockCholesky<kSize>::BlockCholesky(int unknowns, const std::vector<std::pair<int, int>>& pairs)
    : structure_(unknowns, pairs), diagonal_(index(unknowns), Block::Zero()) {
  const auto entry_of = [&](const std::pair<int, int>& pair) {
    const int a = place_of(pair.first);
    const int b = place_of(pair.second);
    return Entry{std::max(a, b), std::min(a, b)};
  };
  for (const auto& pair : pairs) entries_.push_back(entry_of(pair));
  std::sort(entries_.begin(), entries_.end());
  entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
  off_diagonal_.assign(entries_.size(), Block::Zero());
  for (const auto& pair : pairs) {
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), entry_of(pair));
    block_of_pair_.push_back(static_cast<int>(found - entries_.begin()));
  }

  std::size_t panels = 0, rests = 0, most_rests = 0;
  std::vector<std::size_t> of_children(structure_.fronts.size(), 0);
  auto entry = entries_.begin();
  for (std::size_t f = 0; f < structure_.fronts.size(); ++f) {
    const Front& front = structure_.fronts[f];
    entries_of_front_.push_back(static_cast<int>(entry - entries_.begin()));
    for (; entry != entries_.end() && entry->column < front.first + front.columns; ++entry) {
      row_in_front_.push_back(front.row_of(entry->row));
    }
    panel_of_front_.push_back(panels);
    panels += index(kSize * front.rows()) * index(kSize * front.columns);
    const std::size_t rest = square(kSize * front.below.size());
    most_rests = std::max(most_rests, rests + rest);
    rests += rest - of_children[f];
    if (front.parent >= 0) of_children[index(front.parent)] += rest;
  }
  entries_of_front_.push_back(static_cast<int>(entries_.size()));
  panels_.resize(panels + kSlack);
  rests_.resize(most_rests + kSlack);
}

template <int kSize>
void BlockCholesky<kSize>::set_zero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Block::Zero());
  std::fill(off_diagonal_.begin(), off_diagonal_.end(), Block::Zero());
}

template <int kSize>
Eigen::VectorXd BlockCholesky<kSize>::diagonal_entries() const {
  Eigen::VectorXd entries(size());
  for (std::size_t place = 0; place < diagonal_.size(); ++place) {
    entries.segment<kSize>(kSize * static_cast<int>(place)) = diagonal_[place].diagonal();
  }
  return entries;
}

template <int kSize>
Eigen::VectorXd BlockCholesky<kSize>::times(const Eigen::VectorXd& vector) const {
  Eigen::VectorXd product(size());
  for (std::size_t place = 0; place < diagonal_.size(); ++place) {
    const int at = kSize * static_cast<int>(place);
    product.segment<kSize>(at) = diagonal_[place] * vector.segment<kSize>(at);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const int row = kSize * entries_[i].row;
    const int column = kSize * entries_[i].column;
    product.segment<kSize>(row) += off_diagonal_[i] * vector.segment<kSize>(column);
    product.segment<kSize>(column) += off_diagonal_[i].transpose() * vector.segment<kSize>(row);
  }
  return product;
}

// Lower triangles alone count.
template <int kSize>
void BlockCholesky<kSize>::add_child(const Front& child, const double* its_rest,
                                     const Front& parent, double* panel, double* rest) const {
  const int count = static_cast<int>(child.below.size());
  const int rows = kSize * parent.rows();
  const int rest_rows = rows - kSize * parent.columns;
  for (int column = 0; column < count; ++column) {
    const int to = child.in_parent[index(column)];
    const bool is_in_panel = to < parent.columns;
    for (int c = 0; c < kSize; ++c) {
      const double* from =
          its_rest + static_cast<std::ptrdiff_t>(kSize * column + c) * kSize * count;
      double* target =
          is_in_panel
              ? panel + static_cast<std::ptrdiff_t>(kSize * to + c) * rows
              : rest + static_cast<std::ptrdiff_t>(kSize * (to - parent.columns) + c) * rest_rows -
                    kSize * parent.columns;
      for (int row = column; row < count; ++row) {
        const double* values = from + kSize * row;
        double* sums = target + kSize * child.in_parent[index(row)];
        for (int r = 0; r < kSize; ++r) sums[r] += values[r];
      }
    }
  }
}

// The matrix's own entries; `rest` becomes zero.
template <int kSize>
void BlockCholesky<kSize>::assemble(std::size_t f, const Eigen::VectorXd& added, double* rest) {
  const Front& front = structure_.fronts[f];
  const int rows = kSize * front.rows();
  double* panel = panels_.data() + panel_of_front_[f];
  std::fill_n(panel, static_cast<std::ptrdiff_t>(rows) * kSize * front.columns, 0.0);
  std::fill_n(rest, square(kSize * front.below.size()), 0.0);
  const auto block_at = [&](int row, int column) {
    return Eigen::Map<Block, 0, Eigen::OuterStride<>>(
        panel + static_cast<std::ptrdiff_t>(kSize * column) * rows + kSize * row,
        Eigen::OuterStride<>(rows));
  };
  for (int column = 0; column < front.columns; ++column) {
    const int place = front.first + column;
    auto block = block_at(column, column);
    block = diagonal_[index(place)];
    block.diagonal() += added.segment<kSize>(kSize * place);
  }
  for (int i = entries_of_front_[f]; i < entries_of_front_[f + 1]; ++i) {
    block_at(row_in_front_[index(i)], entries_[index(i)].column - front.first) =
        off_diagonal_[index(i)];
  }
}

template <int kSize>
bool BlockCholesky<kSize>::factorize(const Eigen::VectorXd& added) {
  std::vector<std::size_t> waiting;  // fronts whose rests are on the stack
  std::size_t top = 0;
  for (std::size_t f = 0; f < structure_.fronts.size(); ++f) {
    const Front& front = structure_.fronts[f];
    double* panel = panels_.data() + panel_of_front_[f];
    double* rest = rests_.data() + top;
    assemble(f, added, rest);
    std::size_t begin = top;
    while (!waiting.empty() && structure_.fronts[waiting.back()].parent == static_cast<int>(f)) {
      const Front& child = structure_.fronts[waiting.back()];
      begin -= square(kSize * child.below.size());
      add_child(child, rests_.data() + begin, front, panel, rest);
      waiting.pop_back();
    }
    if (!factorize_front(kSize * front.rows(), kSize * front.columns, panel, rest)) return false;
    const std::size_t size = square(kSize * front.below.size());
    if (begin != top) std::copy(rest, rest + size, rests_.data() + begin);
    top = begin + size;
    if (size > 0) waiting.push_back(f);
  }
  return true;
}

// L y = x: each column's unknown, then what it takes from all rows below.
template <int kSize>
void BlockCholesky<kSize>::solve_forward(double* x, std::vector<double>& rows) const {
  for (std::size_t f = 0; f < structure_.fronts.size(); ++f) {
    const Front& front = structure_.fronts[f];
    const int columns = kSize * front.columns;
    const int count = kSize * front.rows();
    double* own = x + kSize * front.first;
    std::copy_n(own, columns, rows.data());
    std::fill(rows.begin() + columns, rows.begin() + count, 0.0);
    const double* column = panels_.data() + panel_of_front_[f];
    for (int j = 0; j < columns; ++j, column += count) {
      const double value = rows[index(j)] / column[j];
      own[j] = value;
      for (int r = j + 1; r < count; ++r) rows[index(r)] -= value * column[r];
    }
    const double* taken = rows.data() + columns;
    for (const int place : front.below) {
      for (int r = 0; r < kSize; ++r) x[kSize * place + r] += *taken++;
    }
  }
}

// L' x = y
template <int kSize>
void BlockCholesky<kSize>::solve_backward(double* x, std::vector<double>& rows) const {
  using Numbers = Eigen::Map<const Eigen::VectorXd>;
  for (std::size_t f = structure_.fronts.size(); f-- > 0;) {
    const Front& front = structure_.fronts[f];
    const int columns = kSize * front.columns;
    const int count = kSize * front.rows();
    double* below = rows.data() + columns;
    for (const int place : front.below) {
      for (int r = 0; r < kSize; ++r) *below++ = x[kSize * place + r];
    }
    const double* panel = panels_.data() + panel_of_front_[f];
    for (int j = columns - 1; j >= 0; --j) {
      const double* column = panel + static_cast<std::ptrdiff_t>(j) * count;
      const int left = count - j - 1;
      const double known = Numbers(column + j + 1, left).dot(Numbers(rows.data() + j + 1, left));
      rows[index(j)] = (x[kSize * front.first + j] - known) / column[j];
      x[kSize * front.first + j] = rows[index(j)];
    }
  }
}

template <int kSize>
Eigen::MatrixXd BlockCholesky<kSize>::solve(const Eigen::MatrixXd& right_hand_sides) const {
  int most_rows = 0;
  for (const Front& front : structure_.fronts) most_rows = std::max(most_rows, front.rows());
  std::vector<double> rows(index(kSize * most_rows));
  Eigen::MatrixXd solution = right_hand_sides;
  for (Eigen::Index side = 0; side < solution.cols(); ++side) {
    solve_forward(solution.col(side).data(), rows);
    solve_backward(solution.col(side).data(), rows);
  }
  return solution;
}

template class BlockCholesky<2>;
template class BlockCholesky<3>;
template class BlockCholesky<6>;

}  // namespace mapbed
