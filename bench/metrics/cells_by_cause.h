#pragma once

#include "algorithms/grid/occupancy_map.h"
#include "bench/metrics/map_error.h"
#include "bench/metrics/true_causes.h"
#include "core/log/sensor_log.h"

namespace mapbed {

// What made the cells of a map that are at least options.occupied and none of the world's: by most
// of the beams that end in them.
struct SpuriousCells {
  long of_movers = 0;   // of what moves in this recording
  long of_people = 0;   // of these, made by people more than by doors and other things
  long of_resting = 0;  // of what could and does not
  long of_others = 0;   // of the place itself, drawn at a wrong place, or of noise
};

// `log` has the scans of the path (world_from_robot), as build_map() takes them.
SpuriousCells spurious_cells(const OccupancyMap& map, const TrueMap& truth, const SensorLog& log,
                             const Trajectory& world_from_robot, const TrueCauses& causes,
                             const MapErrorOptions& options = {});

// Of the true occupied cells that a map of all beams shows, the fraction that one without the
// dynamic beams does not; NaN where there are none. Both of the same path.
double lost_cells(const OccupancyMap& of_all, const OccupancyMap& without_dynamic,
                  const TrueMap& truth, const MapErrorOptions& options = {});

}  // namespace mapbed
