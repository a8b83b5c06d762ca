#include "algorithms/grid/map_builder.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "algorithms/grid/counting_map.h"
#include "algorithms/grid/end_point_map.h"
#include "algorithms/grid/odds_map.h"
#include "core/check.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

using ScanList = std::vector<const LaserScan*>;

ScanList scans_of(const SensorLog& log) {
  ScanList scans;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan != nullptr && scan->robot_from_laser.is_level()) scans.push_back(scan);
  }
  return scans;
}

// Half the side of the largest grid, so that one that starts anywhere near the origin holds it.
double reach(double resolution) {
  return 0.5 * OccupancyMap::kMaxTiles * OccupancyMap::kTileSide * resolution;
}

void check(const MapOptions& options) {
  check(options.odds);
  if (!(options.resolution > 0.0 && options.beams.usable_range > 0.0)) {
    throw InputError("a map's resolution and usable range must be greater than 0 m");
  }
  if (!(2.0 * options.beams.usable_range < reach(options.resolution))) {
    throw InputError(fmt::format(
        "a map cannot take beams of {} m in cells of {} m; choose larger cells or a smaller "
        "usable_range",
        options.beams.usable_range, options.resolution));
  }
}

// Each scan has its pose, and the grid reaches far enough.
void check(const ScanList& scans, const Trajectory& map_from_robot, const MapOptions& options) {
  CHECK(scans.size() == map_from_robot.size());
  const double limit = reach(options.resolution) - options.beams.usable_range;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Stamped<Pose2>& stamped = map_from_robot[i];
    CHECK(stamped.time == scans[i]->time);
    const Pose2 laser = stamped.pose * scans[i]->robot_from_laser.planar;
    if (std::abs(laser.x) < limit && std::abs(laser.y) < limit) continue;
    throw InputError(fmt::format(
        "the pose at {:.3f} s, ({} m, {} m), lies outside the {:.0f} m about the origin that a map "
        "of {} m per cell can hold; choose larger cells or move the trajectory to the origin",
        stamped.time, laser.x, laser.y, limit, options.resolution));
  }
}

// Poses, and labels of their scans or none.
struct Placed {
  const Trajectory& map_from_robot;
  std::span<const ScanLabels> labels = {};
};

template <class Map>
void insert_all(const ScanList& scans, const Placed& placed, const BeamLimits& limits, Map& map) {
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for_each_beam(*scans[i], placed.map_from_robot[i].pose, limits, [&](std::size_t n, Beam beam) {
      if (!placed.labels.empty() && is_dynamic(placed.labels[i], n)) beam.hit = false;
      map.insert(beam);
    });
  }
}

OccupancyMap build(const ScanList& scans, const Placed& placed, const MapOptions& options) {
  check(options);
  check(scans, placed.map_from_robot, options);
  check_labels(scans, placed.labels);
  const GridFrame frame{.resolution = options.resolution};
  if (options.model == MapModel::counting) {
    CountingMap map(frame);
    insert_all(scans, placed, options.beams, map);
    return std::move(map).occupancy();
  }
  if (options.model == MapModel::odds) {
    OddsMap map(frame, options.odds);
    insert_all(scans, placed, options.beams, map);
    return map.occupancy();
  }
  EndPointMap map(frame);
  insert_all(scans, placed, options.beams, map);
  return options.model == MapModel::end_points_odds ? map.occupancy_by_odds(options.odds)
                                                    : map.occupancy_by_counting();
}

}  // namespace

void check_labels(std::span<const LaserScan* const> scans, std::span<const ScanLabels> labels) {
  if (labels.empty()) return;
  CHECK(labels.size() == scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    CHECK(labels[i].time == scans[i]->time);
    CHECK(labels[i].static_probability.size() == scans[i]->ranges.size());
  }
}

OccupancyMap build_map(std::span<const LaserScan> scans, const Trajectory& map_from_robot,
                       const MapOptions& options) {
  ScanList list;
  for (const LaserScan& scan : scans) list.push_back(&scan);
  return build(list, {map_from_robot}, options);
}

OccupancyMap build_map(const SensorLog& log, const Trajectory& map_from_robot,
                       const MapOptions& options, std::span<const ScanLabels> labels) {
  return build(scans_of(log), {map_from_robot, labels}, options);
}

std::vector<const LaserScan*> scans_for_map(const SensorLog& log, const Trajectory& map_from_robot,
                                            const MapOptions& options) {
  check(options);
  ScanList scans = scans_of(log);
  check(scans, map_from_robot, options);
  return scans;
}

CellBox box_of_beams(const SensorLog& log, const Trajectory& map_from_robot,
                     const MapOptions& options) {
  const ScanList scans = scans_for_map(log, map_from_robot, options);
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for_each_beam(*scans[i], map_from_robot[i].pose, options.beams,
                  [&](std::size_t, const Beam& beam) { box.extend(beam.start).extend(beam.end); });
  }
  if (box.isEmpty()) return {};
  const auto cell_of = [&](const Eigen::Vector2d& point) {
    return CellIndex{static_cast<int>(std::floor(point.x() / options.resolution)),
                     static_cast<int>(std::floor(point.y() / options.resolution))};
  };
  return {cell_of(box.min()), cell_of(box.max())};
}

}  // namespace mapbed
