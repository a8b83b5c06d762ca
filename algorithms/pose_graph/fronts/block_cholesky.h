#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "algorithms/pose_graph/fronts/front_structure.h"

namespace mapbed {

// A symmetric matrix of sparse kSize x kSize blocks, and its Cholesky factor by dense fronts
// (multifrontal; Duff, Reid 1983). Where entries are, and the order in which unknowns are
// eliminated, is found once; values are filled in place, again and again. Vectors hold the unknowns
// in the order of elimination, that of unknown u from kSize * place_of(u) on.
template <int kSize>
class BlockCholesky {
 public:
  using Block = Eigen::Matrix<double, kSize, kSize>;

  // `pairs`: the unknowns between which there are blocks, in either order, as often as one likes.
  BlockCholesky(int unknowns, const std::vector<std::pair<int, int>>& pairs);

  int size() const { return kSize * static_cast<int>(diagonal_.size()); }
  int place_of(int unknown) const { return structure_.places[static_cast<std::size_t>(unknown)]; }
  // For off_diagonal() and add(): the block of the row and column of the i-th of `pairs`.
  int block_of(std::size_t pair) const { return block_of_pair_[pair]; }

  void set_zero();
  Block& diagonal(int place) { return diagonal_[static_cast<std::size_t>(place)]; }
  // Below the diagonal: of the later place's rows and the earlier place's columns.
  Block& off_diagonal(int block) { return off_diagonal_[static_cast<std::size_t>(block)]; }

  Eigen::VectorXd diagonal_entries() const;
  Eigen::VectorXd times(const Eigen::VectorXd& vector) const;

  // Of the matrix with `added` on its diagonal. False where it is not positive definite.
  bool factorize(const Eigen::VectorXd& added);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;  // by the last factor

 private:
  struct Entry {  // a block below the diagonal
    int row = 0, column = 0;
    bool operator<(const Entry& other) const {
      return std::pair(column, row) < std::pair(other.column, other.row);
    }
    bool operator==(const Entry&) const = default;
  };

  void assemble(std::size_t front, const Eigen::VectorXd& added, double* rest);
  void add_child(const Front& child, const double* its_rest, const Front& parent, double* panel,
                 double* rest) const;
  // One right-hand side in place; `rows` has room for those of any front.
  void solve_forward(double* x, std::vector<double>& rows) const;
  void solve_backward(double* x, std::vector<double>& rows) const;

  FrontStructure structure_;
  std::vector<Entry> entries_;         // by columns, then rows
  std::vector<int> entries_of_front_;  // where those of each begin; one more at the end
  std::vector<int> row_in_front_;      // of each entry
  std::vector<int> block_of_pair_;
  std::vector<Block> diagonal_, off_diagonal_;
  std::vector<std::size_t> panel_of_front_;  // where it begins
  std::vector<double> panels_;
  std::vector<double> rests_;  // of fronts whose parent is not done yet, a stack
};

}  // namespace mapbed
