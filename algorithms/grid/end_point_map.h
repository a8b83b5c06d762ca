#pragma once

#include <cstdint>

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/grid/odds_model.h"
#include "algorithms/scan/beam.h"

namespace mapbed {

// Fast approximation of section 2.2.4: only the cells in which beams end, so that the map stays
// sparse. Knows no free space and cannot take back an end point that somebody passing by caused.
class EndPointMap {
 public:
  explicit EndPointMap(const GridFrame& frame) : end_points_(frame) {}

  void insert(const Beam& beam);
  OccupancyMap occupancy_by_odds(const OddsModel& model) const;  // (2.16) put right
  OccupancyMap occupancy_by_counting() const;                    // (2.17): 1 where a beam ended

 private:
  TiledGrid<std::uint32_t> end_points_;  // how many beams ended in the cell
};

}  // namespace mapbed
