#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/Cholesky>

#include "algorithms/pose_graph/sparse_factor.h"
#include "core/check.h"

namespace mapbed {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// A removal that leaves less than this part of the information in some direction is none: the rest
// is rounding.
constexpr double kLeastLeft = 1e-13;

template <int B>
using Block = Eigen::Matrix<double, B, B>;

// L_jj, W_j become L_jj C, 0 where C C' = I + V V', V = L_jj^-1 W_j. The rows below follow by the
// same orthogonal matrix.
template <int B>
struct Addition {
  Block<B> c;
  Block<B> l_of_l, l_of_w, w_of_l, w_of_w;  // L' = L l_of_l + W l_of_w; W' = L w_of_l + W w_of_w

  Addition(const Block<B>& diagonal, const Block<B>& front) {
    const Block<B> v = diagonal.template triangularView<Eigen::Lower>().solve(front);
    c = (Block<B>::Identity() + v * v.transpose()).llt().matrixL();
    const Block<B> d = (Block<B>::Identity() + v.transpose() * v).llt().matrixL();
    l_of_l = c.template triangularView<Eigen::Lower>().solve(Block<B>::Identity()).transpose();
    w_of_w = d.template triangularView<Eigen::Lower>().solve(Block<B>::Identity()).transpose();
    l_of_w = v.transpose() * l_of_l;
    w_of_l = -v * w_of_w;
  }

  template <class Rows, class Change>
  void apply(Rows&& l, Change&& w) const {
    const Eigen::Matrix<double, Eigen::Dynamic, B> old = l;
    l = old.lazyProduct(l_of_l) + w.lazyProduct(l_of_w);
    w = (old.lazyProduct(w_of_l) + w.lazyProduct(w_of_w)).eval();
  }
};

// The same for C C' = I - V V'. W' is made of the new L, which keeps errors small.
template <int B>
struct Removal {
  Block<B> c;
  double least_left = 0.0;                  // 0: indefinite
  Block<B> l_of_l, l_of_w, w_of_l, w_of_w;  // L' = L l_of_l + W l_of_w; W' = L' w_of_l + W w_of_w

  Removal(const Block<B>& diagonal, const Block<B>& front) {
    const Block<B> v = diagonal.template triangularView<Eigen::Lower>().solve(front);
    const Eigen::LLT<Block<B>> left(Block<B>::Identity() - v * v.transpose());
    const Eigen::LLT<Block<B>> right(Block<B>::Identity() - v.transpose() * v);
    if (left.info() != Eigen::Success || right.info() != Eigen::Success) return;
    c = left.matrixL();
    least_left = c.diagonal().array().square().minCoeff();
    l_of_l = c.template triangularView<Eigen::Lower>().solve(Block<B>::Identity()).transpose();
    l_of_w = -v.transpose() * l_of_l;
    w_of_w = right.matrixL();
    w_of_l = -right.matrixL().solve(Block<B>(v.transpose() * c)).transpose();
  }

  template <class Rows, class Change>
  void apply(Rows&& l, Change&& w) const {
    l = (l.lazyProduct(l_of_l) + w.lazyProduct(l_of_w)).eval();
    w = (l.lazyProduct(w_of_l) + w.lazyProduct(w_of_w)).eval();
  }
};

}  // namespace

template <int B>
typename SparseFactor<B>::Change SparseFactor<B>::change_of(const NodeRows<B>& rows) const {
  Change change;
  change.value = rows.value;
  const int first = places_[at(rows.first)];
  const int second = rows.second < 0 ? first : places_[at(rows.second)];
  change.place = std::min(first, second);
  change.front = (first <= second ? rows.of_first : rows.of_second).transpose();
  change.rest.setZero(columns_[at(change.place)].size * B, B);
  if (first != second) {
    change.rest.template middleRows<B>(index_of(std::max(first, second), change.place) * B) =
        (first < second ? rows.of_second : rows.of_first).transpose();
  } else if (rows.second >= 0) {
    change.front += rows.of_second.transpose();
  }
  return change;
}

// To the parent in the elimination tree, which has all rows of its child. False at the root.
template <int B>
bool SparseFactor<B>::advance(Change& change) const {
  const std::span<const int> rows = rows_below(change.place);
  if (rows.empty()) return false;
  change.place = rows.front();
  change.front = change.rest.template topRows<B>();
  const std::span<const int> next = rows_below(change.place);
  Eigen::Matrix<double, Eigen::Dynamic, B> rest(static_cast<int>(next.size()) * B, B);
  if (next.size() + 1 == rows.size()) {  // the same rows
    rest = change.rest.bottomRows(rest.rows());
  } else {
    std::size_t r = 1;
    for (std::size_t t = 0; t < next.size(); ++t) {
      auto block = rest.template middleRows<B>(static_cast<int>(t) * B);
      if (r < rows.size() && rows[r] == next[t]) {
        block = change.rest.template middleRows<B>(static_cast<int>(r++) * B);
      } else {
        block.setZero();
      }
    }
    CHECK(r == rows.size());
  }
  change.rest = std::move(rest);
  return true;
}

template <int B>
void SparseFactor<B>::add(const NodeRows<B>& rows) {
  CHECK(factored_);
  if (rows.second >= 0 && rows.second != rows.first) {
    const auto [first, last] = std::minmax(places_[at(rows.first)], places_[at(rows.second)]);
    link(first, last);
  }
  Change change = change_of(rows);
  do {
    Block& diagonal = diagonal_[at(change.place)];
    Vector& reduced = reduced_[at(change.place)];
    if (diagonal(0, 0) == 0.0) {  // a new node, where the rows end: all of the error can be met
      diagonal = (change.front * change.front.transpose()).llt().matrixL();
      reduced = diagonal.template triangularView<Eigen::Lower>().solve(change.front * change.value);
      change.value.setZero();
      break;
    }
    const Addition<B> addition(diagonal, change.front);
    diagonal = (diagonal * addition.c).eval();
    addition.apply(panel(change.place), change.rest);
    addition.apply(reduced.transpose(), change.value.transpose());
  } while (advance(change));
  minimum_ += change.value.squaredNorm();
  rounding_ += 1.0;
}

template <int B>
bool SparseFactor<B>::remove(const NodeRows<B>& rows) {
  CHECK(factored_);
  struct Before {
    int place;
    Block diagonal;
    Vector reduced;
    Eigen::Matrix<double, Eigen::Dynamic, B> panel;
  };
  std::vector<Before> before;
  double least_left = 1.0;
  Change change = change_of(rows);
  do {
    const int p = change.place;
    before.push_back({p, diagonal_[at(p)], reduced_[at(p)], panel(p)});
    const Removal<B> removal(diagonal_[at(p)], change.front);
    least_left = std::min(least_left, removal.least_left);
    if (least_left < kLeastLeft) {
      before.pop_back();
      for (Before& column : before) {
        diagonal_[at(column.place)] = column.diagonal;
        reduced_[at(column.place)] = column.reduced;
        panel(column.place) = column.panel;
      }
      return false;
    }
    diagonal_[at(p)] = (diagonal_[at(p)] * removal.c).eval();
    removal.apply(panel(p), change.rest);
    removal.apply(reduced_[at(p)].transpose(), change.value.transpose());
  } while (advance(change));
  minimum_ -= change.value.squaredNorm();
  rounding_ += 1.0 / least_left;
  return true;
}

template <int B>
void SparseFactor<B>::append(const NodeRows<B>& rows) {
  const int node = nodes();
  CHECK(rows.first != rows.second && (rows.first == node || rows.second == node));
  nodes_.push_back(node);
  places_.push_back(node);
  columns_.push_back({rows_.size(), 0});
  diagonal_.push_back(Block::Zero());
  reduced_.push_back(Vector::Zero());
  add(rows);
}

// A H^-1 A' = P'P with L P = A', whose columns are zero off the ways from both nodes to the root.
template <int B>
typename SparseFactor<B>::Block SparseFactor<B>::covariance(const NodeRows<B>& rows) const {
  CHECK(factored_);
  std::vector<Block> right(nodes_.size(), Block::Zero());
  std::vector<char> reached(nodes_.size(), 0);
  const auto reach = [&](int node, const Block& of_node) {
    right[at(places_[at(node)])] += of_node.transpose();
    reached[at(places_[at(node)])] = 1;
  };
  reach(rows.first, rows.of_first);
  if (rows.second >= 0) reach(rows.second, rows.of_second);

  Block sum = Block::Zero();
  for (int p = 0; p < nodes(); ++p) {
    if (!reached[at(p)]) continue;
    const Block done = diagonal_[at(p)].template triangularView<Eigen::Lower>().solve(right[at(p)]);
    sum += done.transpose() * done;
    const auto column = panel(p);
    const std::span<const int> below = rows_below(p);
    for (std::size_t r = 0; r < below.size(); ++r) {
      right[at(below[r])] -= column.template middleRows<B>(static_cast<int>(r) * B) * done;
      reached[at(below[r])] = 1;
    }
  }
  return sum;
}

// Makes an entry of H at row last, column first, and all entries of L that follow from it: a
// column's rows but the first are rows of the first, its parent in the elimination tree.
template <int B>
void SparseFactor<B>::link(int first, int last) {
  std::vector<int> carried = {last};
  for (int p = first; !carried.empty();) {
    const std::span<const int> rows = rows_below(p);
    std::vector<int> all;
    std::set_union(rows.begin(), rows.end(), carried.begin(), carried.end(),
                   std::back_inserter(all));
    if (all.size() == rows.size()) return;
    grow(p, all);
    p = all.front();
    carried.assign(all.begin() + 1, all.end());
  }
}

// The column at the end of the store, with zeros in its new rows.
template <int B>
void SparseFactor<B>::grow(int place, const std::vector<int>& rows) {
  const Column old = columns_[at(place)];
  const Column grown{rows_.size(), static_cast<int>(rows.size())};
  rows_.insert(rows_.end(), rows.begin(), rows.end());
  panels_.resize(rows_.size() * B * B, 0.0);
  const auto from = panel(place);
  const std::span<const int> old_rows = rows_below(place);
  columns_[at(place)] = grown;
  auto to = panel(place);
  std::size_t t = 0;
  for (int r = 0; r < old.size; ++r) {
    while (rows[t] != old_rows[at(r)]) ++t;
    to.template middleRows<B>(static_cast<int>(t) * B) = from.template middleRows<B>(r * B);
  }
  unused_ += at(old.size);
  if (unused_ * 2 > rows_.size()) pack();
}

template class SparseFactor<3>;
template class SparseFactor<4>;
template class SparseFactor<6>;

}  // namespace mapbed
