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

// Writes what `read` knows of a cell into `map`.
template <class Reader>
auto write_occupancy(OccupancyMap& map, Reader& read) {
  return [writer = OccupancyMap::Writer(map), &read](CellIndex index, const auto& cell) mutable {
    const Occupancy occupancy = read(cell);
    if (occupancy.known()) writer.at(index) = occupancy;
  };
}

// A map of `read(cell)`, the Occupancy that a model's cell stands for; tiles of which nothing is
// known are left out.
template <class Cell, class Reader>
OccupancyMap occupancy_of(const TiledGrid<Cell>& cells, Reader&& read) {
  OccupancyMap map(cells.frame());
  cells.for_each(write_occupancy(map, read));
  return map;
}

// The same of cells that are given up for it, their memory tile by tile.
template <class Cell, class Reader>
OccupancyMap occupancy_of(TiledGrid<Cell>&& cells, Reader&& read) {
  OccupancyMap map(cells.frame());
  cells.drain(write_occupancy(map, read));
  return map;
}

}  // namespace mapbed
