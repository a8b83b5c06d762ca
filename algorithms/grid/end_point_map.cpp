#include "algorithms/grid/end_point_map.h"

#include <algorithm>

namespace mapbed {

void EndPointMap::insert(const Beam& beam) {
  if (beam.hit) ++end_points_.at(end_points_.cell_of(beam.end));
}

OccupancyMap EndPointMap::occupancy_by_odds(const OddsModel& model) const {
  return occupancy_of(end_points_, [&](std::uint32_t c_occ) {
    if (c_occ == 0) return Occupancy{};
    return known(std::min(odds_occupancy(c_occ, 0.0, model), model.highest));
  });
}

OccupancyMap EndPointMap::occupancy_by_counting() const {
  return occupancy_of(end_points_,
                      [](std::uint32_t c_occ) { return c_occ == 0 ? Occupancy{} : known(1.0); });
}

}  // namespace mapbed
