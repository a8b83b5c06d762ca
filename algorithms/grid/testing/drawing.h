#pragma once

#include <string>

#include "algorithms/grid/occupancy_map.h"

namespace mapbed {

// A map as it would be drawn by hand, the row of largest y first, rows ended by '|':
//   '.' free (below 0.5), '#' occupied, blank unknown.
// Shows the cells of `box`.
inline std::string drawing_of(const OccupancyMap& map, const CellBox& box) {
  std::string drawing;
  for (int y = box.max.y; y >= box.min.y; --y) {
    for (int x = box.min.x; x <= box.max.x; ++x) {
      const Occupancy& cell = map[{x, y}];
      drawing += !cell.known() ? ' ' : cell.probability < 0.5F ? '.' : '#';
    }
    drawing += '|';
  }
  return drawing;
}

inline std::string drawing_of(const OccupancyMap& map) {
  return drawing_of(map, known_box(map));
}

// The map of such a drawing; its last row is y = 0. '.' is 0 and '#' is 1.
inline OccupancyMap map_of(const std::string& drawing, const GridFrame& frame) {
  OccupancyMap map(frame);
  CellIndex cell{0, static_cast<int>(std::count(drawing.begin(), drawing.end(), '|')) - 1};
  for (const char mark : drawing) {
    if (mark == '|') {
      cell = {0, cell.y - 1};
      continue;
    }
    if (mark != ' ') map.at(cell) = known(mark == '#' ? 1.0 : 0.0);
    ++cell.x;
  }
  return map;
}

}  // namespace mapbed
