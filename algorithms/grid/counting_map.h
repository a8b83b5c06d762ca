#pragma once

#include <cstdint>
#include <optional>

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/scan/beam.h"

namespace mapbed {

// (2.15): the fraction of beams that a cell reflects, by how many ended in it and how many went
// through. None where no beam touched it: 0/0 is unknown.
inline std::optional<double> counting_occupancy(double c_occ, double c_free) {
  if (c_occ + c_free <= 0.0) return std::nullopt;
  return c_occ / (c_occ + c_free);
}

// Counting model, section 2.2.3: the most likely map for given poses when each cell reflects a beam
// with a probability of its own, (2.14). Keeps half transparent things such as glass.
class CountingMap {
 public:
  struct Cell {
    std::uint32_t hits = 0;    // beams that ended in the cell
    std::uint32_t misses = 0;  // beams that covered it without ending in it
  };

  explicit CountingMap(const GridFrame& frame) : cells_(frame) {}

  void insert(const Beam& beam);
  const TiledGrid<Cell>& cells() const { return cells_; }
  OccupancyMap occupancy() const&;
  OccupancyMap occupancy() &&;  // the counts are given up for it

 private:
  TiledGrid<Cell> cells_;
};

}  // namespace mapbed
