#include "algorithms/visibility/saturated_map.h"

#include <algorithm>

#include "algorithms/grid/odds_model.h"
#include "algorithms/visibility/scan_looks.h"

namespace mapbed {

BeamLabels SaturatedMap::labels(std::span<const LaserScan> scans,
                                const Trajectory& map_from_robot) const {
  const double hit = log_odds(options_.p_hit), pass = log_odds(options_.p_pass);
  const double least = log_odds(options_.least), most = log_odds(options_.most);
  TiledGrid<float> odds(options_.resolution);
  TiledGrid<std::uint32_t> last(options_.resolution);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    TiledGrid<float>::Writer writer(odds);
    for_each_look(scans[i], map_from_robot[i].pose, options_.beams, options_.end_margin,
                  static_cast<std::uint32_t>(i + 1), last, [&](CellIndex cell, bool is_hit) {
                    float& l = writer.at(cell);
                    const double next = static_cast<double>(l) + (is_hit ? hit : pass);
                    l = static_cast<float>(std::clamp(next, least, most));
                  });
  }
  return labels_of_ends(scans, map_from_robot, options_.beams, odds.frame(), [&](CellIndex cell) {
    if (last[cell] == 0) return 0.0;  // nobody looked there
    return probability_of(static_cast<double>(odds[cell]));
  });
}

}  // namespace mapbed
