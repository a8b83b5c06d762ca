#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/grid/odds_model.h"
#include "algorithms/scan/beam.h"

namespace mapbed {

// Bayesian update of section 2.2.1 in the form (2.8): each look adds the log odds of (2.12) less
// those of the prior. Looks count as independent, so a cell soon ends near 0 or 1.
class OddsMap {
 public:
  explicit OddsMap(const GridFrame& frame, const OddsModel& model = {});

  void insert(const Beam& beam);
  OccupancyMap occupancy() const;

 private:
  struct Cell {
    float change = 0.0F;  // of the log odds since the prior
    bool seen = false;    // a cell can be back at the prior and yet not unknown
  };

  void look(Cell& cell, double change) const;

  double l_0_, hit_change_, miss_change_, lowest_change_, highest_change_;
  TiledGrid<Cell> cells_;
};

}  // namespace mapbed
