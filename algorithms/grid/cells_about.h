#pragma once

#include <algorithm>

#include "algorithms/grid/grid_frame.h"

namespace mapbed {

// The largest value(cell) of a cell and the eight about it.
template <class Value>
double largest_about(CellIndex cell, Value&& value) {
  double largest = value(cell);
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      largest = std::max(largest, static_cast<double>(value(CellIndex{x, y})));
    }
  }
  return largest;
}

}  // namespace mapbed
