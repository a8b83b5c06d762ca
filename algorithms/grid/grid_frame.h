#pragma once

#include <cmath>

#include <Eigen/Core>

#include "core/check.h"

namespace mapbed {

// The place of a cell in an unbounded grid.
struct CellIndex {
  int x = 0;
  int y = 0;
  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

// The cells' bounding box, both corners inside it; empty where min.x > max.x.
struct CellBox {
  CellIndex min{1, 1};
  CellIndex max{0, 0};
  bool empty() const { return min.x > max.x; }
  int width() const { return max.x - min.x + 1; }
  int height() const { return max.y - min.y + 1; }
  bool contains(CellIndex cell) const {
    return cell.x >= min.x && cell.x <= max.x && cell.y >= min.y && cell.y <= max.y;
  }
  friend bool operator==(const CellBox&, const CellBox&) = default;
};

// Where a grid's cells lie in the map frame: cell (0, 0) covers origin + [0, resolution) in x and
// y.
struct GridFrame {
  double resolution = 0.05;                          // [m] side of a cell, > 0
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // [m] in the map frame

  // In cell sides from the origin: cell (i, j) covers [i, i + 1) x [j, j + 1).
  Eigen::Vector2d in_cells(const Eigen::Vector2d& point) const {
    return (point - origin) / resolution;
  }
  CellIndex cell_of(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d cells = in_cells(point);
    return {static_cast<int>(std::floor(cells.x())), static_cast<int>(std::floor(cells.y()))};
  }
  Eigen::Vector2d corner_of(CellIndex cell) const {  // the one of least x and y
    return origin + Eigen::Vector2d(cell.x, cell.y) * resolution;
  }
  Eigen::Vector2d center_of(CellIndex cell) const {
    return origin + Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5) * resolution;
  }
};

}  // namespace mapbed
