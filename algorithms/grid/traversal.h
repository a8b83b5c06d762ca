#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <Eigen/Core>

#include "algorithms/grid/grid_frame.h"
#include "core/check.h"

namespace mapbed {

// A cell and the length [m] of a beam inside it.
struct CoveredCell {
  CellIndex cell;
  double length = 0.0;  // [m]
};

// Exact traversal of a grid along the straight line from `start` to `end` [m], after Amanatides and
// Woo (1987), with each crossing of a cell border computed anew so that no error accumulates.
//
// Calls visit(cell, length) for every cell that the line covers before the one it ends in, in
// order, and returns the last: always frame.cell_of(end), with whatever length is left, 0 where the
// end stands just on the cell's border. Cells that are touched in a corner or along the border only
// are left out. The lengths of all cells add up to |end - start|.
template <class Visitor>
CoveredCell traverse(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                     const GridFrame& frame, Visitor&& visit) {
  struct Axis {
    double to_crossing;  // fraction of the line that lies before the next border on this axis
    double border;       // the next border [cell sides from the start]
    double per_side;     // fraction of the line per cell side
    double step;         // +1 or -1
    int left;            // borders still to cross

    void cross() {
      border += step;
      --left;
      to_crossing = left > 0 ? std::min(border * per_side, 1.0) : 2.0;
    }
  };
  const Eigen::Vector2d from = frame.in_cells(start);
  const Eigen::Vector2d to = frame.in_cells(end);
  constexpr double kFarthest = 1e9;  // cell indices fit into an int; false for NaN
  CHECK((from.array().abs() < kFarthest).all() && (to.array().abs() < kFarthest).all());
  CellIndex cell{static_cast<int>(std::floor(from.x())), static_cast<int>(std::floor(from.y()))};
  const CellIndex last{static_cast<int>(std::floor(to.x())), static_cast<int>(std::floor(to.y()))};

  const auto axis = [](double a, double b, int first_cell, int last_cell) {
    const int borders = std::abs(last_cell - first_cell);
    const double step = b >= a ? 1.0 : -1.0;
    const double border = first_cell + (step > 0.0 ? 1.0 : 0.0) - a;
    // Finite even for the tiniest step over a border, so that 0 * per_side is 0.
    const double per_side = borders > 0 ? std::clamp(1.0 / (b - a), -1e300, 1e300) : 0.0;
    return Axis{borders > 0 ? std::min(border * per_side, 1.0) : 2.0, border, per_side, step,
                borders};
  };
  Axis x = axis(from.x(), to.x(), cell.x, last.x);
  Axis y = axis(from.y(), to.y(), cell.y, last.y);
  const int step_x = x.step > 0.0 ? 1 : -1;
  const int step_y = y.step > 0.0 ? 1 : -1;
  const double total = (end - start).norm();

  double done = 0.0;  // fraction of the line
  while (x.left + y.left > 0) {
    const double next = std::min(x.to_crossing, y.to_crossing);
    if (next > done) visit(cell, (next - done) * total);
    done = next;
    if (x.to_crossing <= y.to_crossing) {
      cell.x += step_x;
      x.cross();
    } else {
      cell.y += step_y;
      y.cross();
    }
  }
  return {last, (1.0 - done) * total};
}

}  // namespace mapbed
