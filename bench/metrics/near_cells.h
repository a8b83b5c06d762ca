#pragma once

#include <cstdint>

#include "algorithms/grid/occupancy_map.h"
#include "core/image/dilation.h"
#include "worlds/geometry/raster.h"

namespace mapbed {

// Cells near which something holds: for a cell within `reach` cells in x and y.
class NearCells {
 public:
  // Answers for the cells of `box`; `holds(cell)` is asked for those around it too.
  template <class Predicate>
  NearCells(const CellBox& box, int reach, Predicate&& holds)
      : box_(box),
        low_{box.min.x - reach, box.min.y - reach},
        near_(box.width() + 2 * reach, box.height() + 2 * reach) {
    for (int y = 0; y < near_.height(); ++y) {
      for (int x = 0; x < near_.width(); ++x) {
        near_.at(x, y) = holds(CellIndex{low_.x + x, low_.y + y}) ? 1 : 0;
      }
    }
    near_ = dilated(near_, reach);
  }

  // False outside of the box.
  bool operator[](CellIndex cell) const {
    return box_.contains(cell) && near_.at(cell.x - low_.x, cell.y - low_.y) != 0;
  }

 private:
  CellBox box_;
  CellIndex low_;
  GrayImage near_;
};

// The cells of a map that the true map's lie in.
inline CellBox cells_under(const TrueMap& truth, const OccupancyMap& map) {
  const Eigen::Vector2d size = truth.resolution * Eigen::Vector2d(truth.width, truth.height);
  return {map.cell_of(truth.origin), map.cell_of(truth.origin + size)};
}

}  // namespace mapbed
