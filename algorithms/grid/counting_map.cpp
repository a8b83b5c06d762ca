#include "algorithms/grid/counting_map.h"

#include "algorithms/grid/traversal.h"

namespace mapbed {

void CountingMap::insert(const Beam& beam) {
  TiledGrid<Cell>::Writer writer(cells_);
  const CoveredCell last = traverse(beam.start, beam.end, cells_.frame(),
                                    [&](CellIndex cell, double) { ++writer.at(cell).misses; });
  if (beam.hit) ++writer.at(last.cell).hits;
}

OccupancyMap CountingMap::occupancy() const {
  return occupancy_of(cells_, [](const Cell& cell) {
    const std::optional<double> fraction = counting_occupancy(cell.hits, cell.misses);
    return fraction ? known(*fraction) : Occupancy{};
  });
}

}  // namespace mapbed
