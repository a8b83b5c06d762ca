#pragma once

#include "algorithms/grid/tiled_grid.h"

namespace mapbed {

// What is believed about one cell: the probability that it is occupied (odds model), or that it
// reflects a beam (counting model). Unknown is neither free nor occupied: nothing was ever seen of
// the cell.
struct Occupancy {
  float probability = -1.0F;  // below 0: unknown
  bool known() const { return probability >= 0.0F; }
  friend bool operator==(const Occupancy&, const Occupancy&) = default;
};

// The map as every model of it reads: what pictures, files, metrics and likelihoods work on.
using OccupancyMap = TiledGrid<Occupancy>;

inline Occupancy known(double probability) {
  return {static_cast<float>(probability)};
}

inline CellBox known_box(const OccupancyMap& map) {
  return map.box_where([](const Occupancy& cell) { return cell.known(); });
}

// A map of `read(cell)`, the Occupancy that a model's cell stands for; tiles of which nothing is
// known are left out.
template <class Cell, class Reader>
OccupancyMap occupancy_of(const TiledGrid<Cell>& cells, Reader&& read) {
  OccupancyMap map(cells.frame());
  OccupancyMap::Writer writer(map);
  cells.for_each([&](CellIndex index, const Cell& cell) {
    const Occupancy occupancy = read(cell);
    if (occupancy.known()) writer.at(index) = occupancy;
  });
  return map;
}

}  // namespace mapbed
