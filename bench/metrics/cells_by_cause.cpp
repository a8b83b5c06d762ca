#include "bench/metrics/cells_by_cause.h"

#include <array>
#include <cstdint>
#include <limits>

#include "algorithms/scan/beam.h"
#include "algorithms/scan/scans_on_path.h"
#include "bench/metrics/near_cells.h"

namespace mapbed {
namespace {

// Beams that end in a cell.
struct Ends {
  std::uint32_t of_movers = 0, of_people = 0, of_resting = 0, of_others = 0;
};

bool is_occupied(const Occupancy& cell, const MapErrorOptions& options) {
  return cell.known() && cell.probability >= options.occupied;
}

TiledGrid<Ends> ends_of(const SensorLog& log, const Trajectory& world_from_robot,
                        const TrueCauses& causes, const GridFrame& frame) {
  TiledGrid<Ends> ends(frame);
  for_each_scan_on_path(log, world_from_robot, [&](const LaserScan& scan, const Pose2& pose) {
    const std::vector<BeamCause> of_beams = causes.of(scan);
    TiledGrid<Ends>::Writer writer(ends);
    for_each_beam(scan, pose, BeamLimits{}, [&](std::size_t n, const Beam& beam) {
      if (!beam.hit) return;
      Ends& cell = writer.at(ends.cell_of(beam.end));
      const Cause cause = of_beams[n].cause;
      const bool moves = cause == Cause::moving || cause == Cause::waiting;
      ++(moves ? cell.of_movers : cause == Cause::resting ? cell.of_resting : cell.of_others);
      if (moves && of_beams[n].kind == EntityKind::person) ++cell.of_people;
    });
  });
  return ends;
}

// Cells of the map near which the truth has something.
NearCells near_true(const OccupancyMap& map, const TrueMap& truth, int tolerance) {
  return {cells_under(truth, map), tolerance, [&](CellIndex index) {
            const Eigen::Vector2d at =
                (map.frame().center_of(index) - truth.origin) / truth.resolution;
            const int x = static_cast<int>(std::floor(at.x()));
            const int y = static_cast<int>(std::floor(at.y()));
            if (x < 0 || y < 0 || x >= truth.width || y >= truth.height) return false;
            return truth.at(x, y) == TrueCell::occupied || truth.at(x, y) == TrueCell::interior;
          }};
}

}  // namespace

SpuriousCells spurious_cells(const OccupancyMap& map, const TrueMap& truth, const SensorLog& log,
                             const Trajectory& world_from_robot, const TrueCauses& causes,
                             const MapErrorOptions& options) {
  const TiledGrid<Ends> ends = ends_of(log, world_from_robot, causes, map.frame());
  const NearCells near = near_true(map, truth, options.tolerance);
  SpuriousCells result;
  map.for_each([&](CellIndex index, const Occupancy& cell) {
    if (!is_occupied(cell, options) || near[index]) return;
    const Ends& made_by = ends[index];
    const std::uint32_t others = made_by.of_resting + made_by.of_others;
    if (made_by.of_movers > others) {
      ++result.of_movers;
      if (2 * made_by.of_people > made_by.of_movers) ++result.of_people;
    } else if (made_by.of_resting > made_by.of_movers + made_by.of_others) {
      ++result.of_resting;
    } else {
      ++result.of_others;
    }
  });
  return result;
}

double lost_cells(const OccupancyMap& of_all, const OccupancyMap& without_dynamic,
                  const TrueMap& truth, const MapErrorOptions& options) {
  const NearCells near = near_true(of_all, truth, options.tolerance);
  long shown = 0, lost = 0;
  of_all.for_each([&](CellIndex index, const Occupancy& cell) {
    if (!is_occupied(cell, options) || !near[index]) return;
    ++shown;
    if (!is_occupied(without_dynamic[index], options)) ++lost;
  });
  return shown == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(lost) / static_cast<double>(shown);
}

}  // namespace mapbed
