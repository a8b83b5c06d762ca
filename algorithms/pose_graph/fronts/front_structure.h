#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace mapbed {

// Columns of a factor, one after the other, that have the same rows below them, so that they are
// worked on as one dense matrix: a front. Rows and columns count blocks.
struct Front {
  int first = 0;               // column
  int columns = 0;             // the first rows of the front are theirs
  std::vector<int> below;      // further rows, ascending
  int parent = -1;             // the front that holds the first row below; -1: none is below
  std::vector<int> in_parent;  // where the rows below are in the parent's rows

  int rows() const { return columns + static_cast<int>(below.size()); }
  int row_of(int place) const;  // of one that the front has
};

// The fronts of a symmetric matrix's Cholesky factor, in an order in which parents come after their
// children, and children of one parent right before it (Duff, Reid 1983). Few more rows than there
// need be are worth fewer and larger fronts.
struct FrontStructure {
  std::vector<int> places;  // of the unknowns, in the order of elimination
  std::vector<Front> fronts;
  std::vector<int> front_of;  // a column

  // `pairs`: the unknowns between which there are entries.
  FrontStructure(int unknowns, const std::vector<std::pair<int, int>>& pairs);
};

}  // namespace mapbed
