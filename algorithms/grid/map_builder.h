#pragma once

#include <span>
#include <vector>

#include "algorithms/grid/occupancy_map.h"
#include "algorithms/grid/odds_model.h"
#include "algorithms/scan/beam.h"
#include "core/config/option.h"
#include "core/geometry/trajectory.h"
#include "core/labels/beam_labels.h"
#include "core/log/sensor_log.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

enum class MapModel : int { counting, odds, end_points_counting, end_points_odds };

struct MapOptions {
  MapModel model = MapModel::counting;
  double resolution = 0.05;  // [m]
  BeamLimits beams{};
  OddsModel odds{};  // for the models of that name
};

template <class Visitor>
void visit_fields(MapOptions& o, Visitor&& visit) {
  visit(
      "model", o.model, {"counting", "odds", "end_points_counting", "end_points_odds"},
      "what a cell keeps: the fraction of beams that it reflects, the odds that it is occupied, or "
      "either from the beams' end points alone");
  visit("resolution", o.resolution, Unit::meter, between(0.005, 10.0), "side of a cell");
  visit("beams", o.beams, "which beams are used, and how far");
  visit("odds", o.odds, "the odds model of one look at a cell");
}

// The map of scans taken at known poses, section 2.2. `map_from_robot` has one pose for each scan,
// in the same order and of the same stamp. Throws InputError where the options contradict each
// other or a pose is farther away than a grid of this resolution reaches.
OccupancyMap build_map(std::span<const LaserScan> scans, const Trajectory& map_from_robot,
                       const MapOptions& options = {});

// The same of the scans in a log, but for those of lasers that are not level. Labels, one for each
// pose or none at all: a beam that met something dynamic clears its path, and its end is left out.
OccupancyMap build_map(const SensorLog& log, const Trajectory& map_from_robot,
                       const MapOptions& options = {}, std::span<const ScanLabels> labels = {});

// The scans of a log that go into its map, one for each pose. Throws as build_map() does.
std::vector<const LaserScan*> scans_for_map(const SensorLog& log, const Trajectory& map_from_robot,
                                            const MapOptions& options = {});

// One for each scan, of as many beams; or none at all.
void check_labels(std::span<const LaserScan* const> scans, std::span<const ScanLabels> labels);

// The cells that the lasers and their beams' ends lie in: a map of these scans is no larger, and
// this is far quicker than to build it.
CellBox box_of_beams(const SensorLog& log, const Trajectory& map_from_robot,
                     const MapOptions& options = {});

}  // namespace mapbed
