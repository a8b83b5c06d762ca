#pragma once

#include <algorithm>
#include <cstdint>

#include "algorithms/grid/tiled_grid.h"
#include "algorithms/grid/traversal.h"
#include "algorithms/scan/beam.h"
#include "core/geometry/pose2.h"
#include "core/sensor/laser_scan.h"

namespace mapbed {

// What one scan says of a cell, however many of its beams look there: a hit outweighs passes. The
// last `end_margin` [m] of a beam before its hit say nothing.
//
// visit(cell index, is_hit) comes once for each cell that the scan looks at, hits first. `last`
// remembers which scan looked at a cell; scans are numbered from 1.
template <class Visitor>
void for_each_look(const LaserScan& scan, const Pose2& map_from_robot, const BeamLimits& limits,
                   double end_margin, std::uint32_t number, TiledGrid<std::uint32_t>& last,
                   Visitor&& visit) {
  TiledGrid<std::uint32_t>::Writer writer(last);
  const auto look = [&](CellIndex cell, bool is_hit) {
    std::uint32_t& seen_by = writer.at(cell);
    if (seen_by == number) return;
    seen_by = number;
    visit(cell, is_hit);
  };
  for_each_beam(scan, map_from_robot, limits, [&](std::size_t, const Beam& beam) {
    if (beam.hit) look(last.cell_of(beam.end), true);
  });
  for_each_beam(scan, map_from_robot, limits, [&](std::size_t, const Beam& beam) {
    const Eigen::Vector2d along = beam.end - beam.start;
    const double length = along.norm();
    const double clear = beam.hit ? length - end_margin : length;
    if (clear <= 0.0) return;
    const Eigen::Vector2d end = beam.start + along * (clear / length);
    const auto pass = [&](CellIndex cell, double) { look(cell, false); };
    pass(traverse(beam.start, end, last.frame(), pass).cell, 0.0);
  });
}

}  // namespace mapbed
