#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mapbed {

// A block of a symmetric matrix over the nodes of a graph. Blocks of the same place add up; of the
// two places of a pair of nodes one is given, either of them.
template <int B>
struct NodeBlock {
  int row = 0, col = 0;  // nodes
  Eigen::Matrix<double, B, B> value;
};

// What a linearised constraint says, as A, a of (6.11) multiplied from the left by a root of R:
// of_first x_first + of_second x_second = value up to errors of unit covariance.
template <int B>
struct NodeRows {
  int first = 0;
  int second = -1;  // -1: of one node alone
  Eigen::Matrix<double, B, B> of_first, of_second;
  Eigen::Matrix<double, B, 1> value;
};

// The Cholesky factor L L' of a sparse symmetric positive definite matrix H of blocks, one block
// row a node, in an order that keeps L sparse, and with it the minimum of
//
//   J(x) = x' H x - 2 h' x + c,
//
// which follows constraints that are added and removed, (6.11) and (6.12) with H + A'RA for the
// information matrix in place of the printed D + S Delta S'. A change costs work only in the
// columns on the way from its nodes to the root of the elimination tree, where blocks of B rows
// take what Davis and Hager's rank-one updates do entry by entry: an orthogonal transformation of
// [L W] to [L' 0], for a removal a hyperbolic one in its mixed form. Eliminating those columns
// again is more accurate but 3.5 times the arithmetic in a graph as dense as Manhattan (2.9
// Mflop, 3.9 without remembering what other columns contribute, against 0.8), 10 times in a sphere
// of poses in space, about as much in graphs with few loops. What rounding has spoiled is told by
// rounding().
//
// Copies share nothing. B: 3, 4 or 6.
template <int B>
class SparseFactor {
 public:
  using Block = Eigen::Matrix<double, B, B>;
  using Vector = Eigen::Matrix<double, B, 1>;

  // Places of blocks are read for the order and the pattern of L alone. No factor yet.
  SparseFactor(int nodes, std::span<const NodeBlock<B>> blocks);

  // Of blocks at those places, or at some of them, and at those that were added since. False where
  // H is not positive definite: there is no factor then. h is by nodes; none: zero.
  bool factorize(std::span<const NodeBlock<B>> blocks, const Eigen::VectorXd& h = {},
                 double c = 0.0);

  // J(x) plus the square of the rows' error. Where they link nodes anew L grows.
  void add(const NodeRows<B>& rows);
  // The same with a node more, first or second, which becomes the last in the order. Its block must
  // be regular.
  void append(const NodeRows<B>& rows);
  // J(x) less the square of the error of rows that were added, which are given as they were then.
  // False where H would not be positive definite: nothing has changed then. L keeps its pattern.
  bool remove(const NodeRows<B>& rows);

  int nodes() const { return static_cast<int>(nodes_.size()); }
  double minimum() const { return minimum_; }                      // of J
  Eigen::VectorXd minimizer() const;                               // where it is, by nodes
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;  // H x = right_side
  double log_determinant() const;                                  // of H
  // Covariance of of_first x_first + of_second x_second where H is the information of x. rows.value
  // is not read.
  Block covariance(const NodeRows<B>& rows) const;

  std::size_t blocks() const;  // of L, those of its diagonal included
  // By how much rounding errors may have grown since factorize(), which makes it 1: an addition is
  // one more, a removal the inverse of the part of the information that it leaves.
  double rounding() const { return rounding_; }

 private:
  struct Column {
    std::size_t begin = 0;  // of its rows in rows_, and of its panel, in blocks
    int size = 0;           // blocks below the diagonal
  };
  // W of H + W W', or H - W W', where the columns before are done.
  struct Change {
    int place = 0;                                  // of the column that is next
    Block front;                                    // rows of W there
    Eigen::Matrix<double, Eigen::Dynamic, B> rest;  // and at the rows below
    Vector value;
  };

  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, B>> panel(int place);
  Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, B>> panel(int place) const;
  std::span<const int> rows_below(int place) const;
  int index_of(int row, int column) const;  // among the rows below, must be there
  void gather(std::span<const NodeBlock<B>> blocks);
  void subtract_from_later(int place);
  Eigen::VectorXd solve_upper(std::vector<Vector> y) const;  // L' x = y, x by nodes
  void link(int first, int last);
  void grow(int place, const std::vector<int>& rows);
  void pack();
  Change change_of(const NodeRows<B>& rows) const;
  bool advance(Change& change) const;

  std::vector<int> nodes_;       // at each place of the order of elimination
  std::vector<int> places_;      // of each node; all below by places
  std::vector<Column> columns_;  // of L
  std::vector<Block> diagonal_;  // of L, lower triangles; zero of a node just appended
  std::vector<int> rows_;        // below the diagonal, ascending in a column
  std::vector<double> panels_;   // column by column B * size times B, column major
  std::size_t unused_ = 0;       // blocks of panels_ that were left when columns grew
  std::vector<Vector> reduced_;  // y of L y = h
  double minimum_ = 0.0;         // c - y'y
  double rounding_ = 1.0;
  bool factored_ = false;
};

}  // namespace mapbed
