#include "algorithms/grid/counting_map.h"

#include <utility>

#include "algorithms/grid/traversal.h"

namespace mapbed {
namespace {

Occupancy occupancy_of_cell(const CountingMap::Cell& cell) {
  const std::optional<double> fraction = counting_occupancy(cell.hits, cell.misses);
  return fraction ? known(*fraction) : Occupancy{};
}

}  // namespace

void CountingMap::insert(const Beam& beam) {
  TiledGrid<Cell>::Writer writer(cells_);
  const CoveredCell last = traverse(beam.start, beam.end, cells_.frame(),
                                    [&](CellIndex cell, double) { ++writer.at(cell).misses; });
  if (beam.hit) ++writer.at(last.cell).hits;
}

OccupancyMap CountingMap::occupancy() const& {
  return occupancy_of(cells_, occupancy_of_cell);
}

OccupancyMap CountingMap::occupancy() && {
  return occupancy_of(std::move(cells_), occupancy_of_cell);
}

}  // namespace mapbed
