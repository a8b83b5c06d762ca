#include "algorithms/pose_graph/fronts/dense_front.h"

#include <algorithm>
#include <cmath>

#include "algorithms/pose_graph/fronts/dense_products.h"

namespace mapbed {
namespace {

// The Cholesky factor of columns from `first` to `end`, those before taken from them already.
bool factorize_columns(int rows, int first, int end, double* panel) {
  for (int j = first; j < end; ++j) {
    double* column = panel + static_cast<std::ptrdiff_t>(j) * rows;
    for (int k = first; k < j; ++k) {
      const double* earlier = panel + static_cast<std::ptrdiff_t>(k) * rows;
      const double factor = earlier[j];
      for (int r = j; r < rows; ++r) column[r] -= factor * earlier[r];
    }
    if (!(column[j] > 0.0)) return false;
    const double scale = 1.0 / std::sqrt(column[j]);
    for (int r = j; r < rows; ++r) column[r] *= scale;
  }
  return true;
}

}  // namespace

bool factorize_front(int rows, int columns, double* panel, double* rest, Processor processor) {
  constexpr int kAtATime = 6;
  const auto subtract = processor == Processor::avx2 ? subtract_product_avx2 : subtract_product_any;
  for (int first = 0; first < columns; first += kAtATime) {
    const int end = std::min(columns, first + kAtATime);
    subtract({rows - first, end - first, first}, panel + first, rows, panel + first, rows,
             panel + static_cast<std::ptrdiff_t>(first) * rows + first, rows);
    if (!factorize_columns(rows, first, end, panel)) return false;
  }
  const int below = rows - columns;
  subtract({below, below, columns}, panel + columns, rows, panel + columns, rows, rest, below);
  return true;
}

}  // namespace mapbed
