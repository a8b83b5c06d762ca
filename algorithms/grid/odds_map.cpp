#include "algorithms/grid/odds_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/grid/traversal.h"

namespace mapbed {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

}  // namespace

OddsMap::OddsMap(const GridFrame& frame, const OddsModel& model)
    : l_0_(log_odds(model.prior)),
      hit_change_(log_odds(model.p_occ) - l_0_),
      miss_change_(log_odds(model.p_free) - l_0_),
      lowest_change_(model.lowest > 0.0 ? log_odds(model.lowest) - l_0_ : -kNoBound),
      highest_change_(model.highest < 1.0 ? log_odds(model.highest) - l_0_ : kNoBound),
      cells_(frame) {}

void OddsMap::look(Cell& cell, double change) const {
  const double sum = static_cast<double>(cell.change) + change;
  cell.change = static_cast<float>(std::clamp(sum, lowest_change_, highest_change_));
  cell.seen = true;
}

void OddsMap::insert(const Beam& beam) {
  TiledGrid<Cell>::Writer writer(cells_);
  const CoveredCell last =
      traverse(beam.start, beam.end, cells_.frame(),
               [&](CellIndex cell, double) { look(writer.at(cell), miss_change_); });
  if (beam.hit) look(writer.at(last.cell), hit_change_);
}

OccupancyMap OddsMap::occupancy() const {
  return occupancy_of(cells_, [this](const Cell& cell) {
    return cell.seen ? known(probability_of(l_0_ + static_cast<double>(cell.change))) : Occupancy{};
  });
}

}  // namespace mapbed
