#include "algorithms/grid/wall_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/grid/traversal.h"
#include "algorithms/scan/surface_points.h"
#include "core/image/map_server.h"

namespace mapbed {
namespace {

constexpr OddsModel kLook{.p_occ = 0.7, .p_free = 0.4};
constexpr double kSurfaceGap = 0.1;  // [m] between hits; larger ones are filled on straight walls

// How many scans saw a surface in the cell, and how many saw through it; which did either last.
struct Evidence {
  std::uint16_t surfaces = 0;
  std::uint16_t passes = 0;
  std::uint32_t last = 0;  // number of the scan, from 1
};

double probability_of(const Evidence& cell) {
  return odds_occupancy(cell.surfaces, cell.passes, kLook);
}

bool is_occupied(const Evidence& cell) {
  return cell.surfaces > 0 && probability_of(cell) > MapServerThresholds{}.occupied;
}

Occupancy occupancy_of_cell(const Evidence& cell) {
  if (is_occupied(cell)) return known(1.0);
  const bool seen_through = cell.passes > 0;
  const bool free = cell.surfaces == 0 || probability_of(cell) < MapServerThresholds{}.free;
  return seen_through && free ? known(0.0) : Occupancy{};
}

// How far [m] before its end a beam runs within a cell of the surface that it ends on: the flatter
// the surface, the farther, by the way to the next hit and the arc between the beams. 0 for all but
// grazing beams.
double grazing_length(const LaserScan& scan, std::size_t beam, double cell) {
  const double range = scan.ranges[beam];
  const double arc = range * std::abs(scan.bearing_step);
  double flattest = INFINITY;  // of the steeper of both neighbours, as the other may be an edge
  for (const std::size_t other : {beam - 1, beam + 1}) {
    if (other >= scan.ranges.size() || !scan.is_hit(other)) continue;
    const double depth = scan.ranges[other] - range;
    flattest = std::min(flattest, std::hypot(depth, arc) / arc);
  }
  return std::isinf(flattest) || flattest < 2.0 ? 0.0 : cell * flattest;
}

// A scan counts once in a cell: for what it is first seen to be, and surfaces come first.
void count(Evidence& cell, std::uint16_t Evidence::*seen, std::uint32_t scan) {
  if (cell.last == scan) return;
  cell.last = scan;
  if (cell.*seen < UINT16_MAX) ++(cell.*seen);
}

class EvidenceMap {
 public:
  EvidenceMap(const GridFrame& frame, const BeamLimits& limits) : limits_(limits), cells_(frame) {}

  // Surfaces, and what lies before them; scans in one order, numbered from 1. `of_place` is the
  // scan without what is dynamic.
  void insert(const LaserScan& scan, const LaserScan& of_place, const Pose2& map_from_robot,
              std::uint32_t number) {
    TiledGrid<Evidence>::Writer writer(cells_);
    const auto surface =
        surface_points(of_place, limits_.usable_range, kSurfaceGap, 0.5 * cells_.resolution());
    for (const SurfacePoint& point : surface) {
      count(writer.at(cells_.cell_of(map_from_robot * point.position)), &Evidence::surfaces,
            number);
    }
    for_each_beam(scan, map_from_robot, limits_, [&](std::size_t n, const Beam& beam) {
      if (scan.is_max_range(n)) return;
      const auto pass = [&](CellIndex index) {
        count(writer.at(index), &Evidence::passes, number);
      };
      const bool ends = beam.hit && of_place.is_hit(n);
      const double grazing = ends ? grazing_length(of_place, n, cells_.resolution()) : 0.0;
      if (grazing == 0.0) {
        traverse(beam.start, beam.end, cells_.frame(), [&](CellIndex c, double) { pass(c); });
        return;
      }
      const double most = (beam.end - beam.start).norm() - grazing;
      double done = 0.0;
      traverse(beam.start, beam.end, cells_.frame(), [&](CellIndex index, double length) {
        done += length;
        if (done <= most) pass(index);
      });
    });
  }

  // What beams without return cleared, after all scans are in.
  void clear_without_return(const LaserScan& scan, const Pose2& map_from_robot,
                            std::uint32_t number) {
    if (scan.max_range > limits_.no_return_range) return;  // they say nothing
    TiledGrid<Evidence>::Writer writer(cells_);
    for_each_beam(scan, map_from_robot, limits_, [&](std::size_t n, const Beam& beam) {
      if (!scan.is_max_range(n)) return;
      bool met_surface = false;
      traverse(beam.start, beam.end, cells_.frame(), [&](CellIndex index, double) {
        met_surface = met_surface || is_at_surface(index);
        if (met_surface) return;
        count(writer.at(index), &Evidence::passes, number);
      });
    });
  }

  OccupancyMap occupancy() && { return occupancy_of(std::move(cells_), occupancy_of_cell); }

 private:
  // Surfaces touch in corners, where a beam slips through.
  bool is_at_surface(CellIndex c) const {
    return is_occupied(cells_[c]) || is_occupied(cells_[{c.x - 1, c.y}]) ||
           is_occupied(cells_[{c.x + 1, c.y}]) || is_occupied(cells_[{c.x, c.y - 1}]) ||
           is_occupied(cells_[{c.x, c.y + 1}]);
  }

  BeamLimits limits_;
  TiledGrid<Evidence> cells_;
};

}  // namespace

OccupancyMap wall_map(const SensorLog& log, const Trajectory& map_from_robot,
                      const MapOptions& options, std::span<const ScanLabels> labels) {
  const std::vector<const LaserScan*> scans = scans_for_map(log, map_from_robot, options);
  check_labels(scans, labels);
  EvidenceMap map(GridFrame{.resolution = options.resolution}, options.beams);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Pose2& pose = map_from_robot[i].pose;
    const auto number = static_cast<std::uint32_t>(i + 1);
    if (labels.empty()) {
      map.insert(*scans[i], *scans[i], pose, number);
    } else {
      map.insert(*scans[i], without_dynamic_beams(*scans[i], labels[i]), pose, number);
    }
  }
  for (std::size_t i = 0; i < scans.size(); ++i)
    map.clear_without_return(*scans[i], map_from_robot[i].pose,
                             static_cast<std::uint32_t>(scans.size() + i + 1));
  return std::move(map).occupancy();
}

}  // namespace mapbed
