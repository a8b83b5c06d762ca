#include "algorithms/visibility/visibility_vote.h"

#include "algorithms/visibility/scan_looks.h"

namespace mapbed {

BeamLabels VisibilityVote::labels(std::span<const LaserScan> scans,
                                  const Trajectory& map_from_robot) const {
  struct Votes {
    float hits = 0.0F;    // scans
    float passes = 0.0F;  // scans
  };
  TiledGrid<Votes> votes(options_.resolution);
  TiledGrid<std::uint32_t> last(options_.resolution);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    TiledGrid<Votes>::Writer writer(votes);
    for_each_look(scans[i], map_from_robot[i].pose, options_.beams, options_.end_margin,
                  static_cast<std::uint32_t>(i + 1), last, [&](CellIndex cell, bool is_hit) {
                    Votes& of_cell = writer.at(cell);
                    ++(is_hit ? of_cell.hits : of_cell.passes);
                  });
  }
  return labels_of_ends(scans, map_from_robot, options_.beams, votes.frame(), [&](CellIndex cell) {
    const Votes& of_cell = votes[cell];
    if (of_cell.hits == 0.0F) return 0.0;
    const double for_it = options_.ratio * static_cast<double>(of_cell.hits);
    return for_it / (for_it + static_cast<double>(of_cell.passes));
  });
}

}  // namespace mapbed
